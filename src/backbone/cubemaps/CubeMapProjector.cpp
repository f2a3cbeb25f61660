#include "backbone/cubemaps/CubeMapProjector.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "gl/StateGuard.h"
#include "scene/Finite.h"
#include "shared/cube_faces.h"
#include "shared/distance_code.h"

namespace aolib {

namespace {

/// How far a code that was exceeded reaches beyond what exceeded it, as a factor: it costs two bits
/// of a logarithm that spans about ten.
constexpr float kRoomInCode = 4.0F;

/// Fade of a new cube map.
constexpr float kFadedOut = -8.0F;
/// Frames over which a cube map fades in or out.
constexpr int kFadeFrames = 32;

} // namespace

CubeMapProjector::CubeMapProjector(TexelAtlas& atlas, CubeMapId id, const glm::vec3& position,
                                   bool pinned, gl::GpuTimer timer)
    : atlas_(&atlas), id_(id), position_(position), pinned_(pinned), fade_(kFadedOut),
      tiles_(atlas.faces.faceSize()), timer_(std::move(timer)) {}

Result<CubeMapProjector> CubeMapProjector::create(const gl::Functions& gl, TexelAtlas& atlas,
                                                  CubeMapId id, const glm::vec3& position,
                                                  bool pinned) {
    auto timer = gl::GpuTimer::create(gl);
    if (!timer) {
        return timer.status();
    }
    return CubeMapProjector(atlas, id, position, pinned, std::move(*timer));
}

// ---- State --------------------------------------------------------------------------------------

bool CubeMapProjector::isFadedOut() const {
    return fade_ <= kFadedOut;
}

void CubeMapProjector::resize(int faceSize) {
    releasePages();
    releaseFaces();
    tiles_ = TileTable(faceSize);
    state_ = State::Queued;
}

void CubeMapProjector::begin() {
    if (state_ == State::Queued) {
        state_ = State::Filling;
    } else if (state_ == State::Stale) {
        becomeVisible();
    }
}

void CubeMapProjector::show() {
    if (state_ == State::Filling) {
        becomeVisible();
    }
}

void CubeMapProjector::stepFade(int passes) {
    constexpr float kStep = -kFadedOut / kFadeFrames;
    if (state_ == State::FadingOut) {
        fade_ = std::max(fade_ - kStep, kFadedOut);
    } else if (state_ == State::FadingIn && !tiles_.hasPendingUndisturbed(passes)) {
        fade_ = std::min(fade_ + kStep, 0.0F);
        becomeVisible();
    }
}

void CubeMapProjector::endFade() {
    if (state_ == State::FadingOut) {
        return;
    }
    fade_ = 0.0F;
    if (state_ == State::FadingIn) {
        becomeVisible();
    }
}

void CubeMapProjector::setFrame(std::uint64_t frame) {
    frame_ = frame;
    tiles_.setFrame(frame);
}

void CubeMapProjector::recordCapture(int layers, std::size_t bytes) {
    captured_ = layers;
    captureBytes_ = bytes;
}

// ---- Texels -------------------------------------------------------------------------------------

bool CubeMapProjector::spanDistances(float nearest, float farthest) {
    // A depth along a face's axis is a distance divided by at most sqrt(3).
    const float least = nearest / std::numbers::sqrt3_v<float>;
    if (least >= nearest_ && farthest <= farthest_) {
        return false;
    }
    const float room = std::isfinite(nearest_) ? kRoomInCode : 1.0F;
    releasePages();
    releaseFaces();
    tiles_.forget();
    nearest_ = least < nearest_ ? least / room : nearest_;
    farthest_ = farthest > farthest_ ? farthest * room : farthest_;
    depthCode_ = shared::distanceSpan(nearest_, farthest_);
    return true;
}

AoStatus CubeMapProjector::allocateFace(int face) {
    if (hasFace(face)) {
        return {};
    }
    const auto layer = atlas_->faces.allocateReserved();
    if (layer) {
        layers_[static_cast<std::size_t>(face)] = *layer;
    }
    return layer.status();
}

AoStatus CubeMapProjector::allocateFaces(const std::array<bool, kFaces>& modelled) {
    for (int face = 0; face < kFaces; ++face) {
        if (!modelled[static_cast<std::size_t>(face)]) {
            releaseFace(face);
        } else if (AoStatus status = allocateFace(face); !status) {
            return status;
        }
    }
    return {};
}

void CubeMapProjector::releaseFace(int face) {
    if (hasFace(face)) {
        atlas_->faces.releaseReserved(layer(face));
        layers_[static_cast<std::size_t>(face)] = kNoLayer;
    }
}

void CubeMapProjector::releaseFaces() {
    for (int face = 0; face < kFaces; ++face) {
        releaseFace(face);
    }
}

Result<int> CubeMapProjector::firstPage(int tile) {
    const auto found = pages_.find(tile);
    return found != pages_.end() ? found->second.front() : addPage(tile);
}

Result<int> CubeMapProjector::addPage(int tile) {
    const auto page = atlas_->pages.allocate();
    if (!page) {
        return page;
    }
    // Each has an entry that refers to the next one: the tile's own, or that of the page before,
    // whose place is a tile's of its layer.
    const TileTable::Region region = tiles_.region(tile);
    FaceStore::PageLocation entry{layer(region.face),
                                  glm::ivec2(region.x, region.y) / TileTable::kTile};
    std::vector<int>& chain = pages_[tile];
    if (!chain.empty()) {
        entry = atlas_->pages.location(chain.back());
    }
    const FaceStore::PageLocation at = atlas_->pages.location(*page);
    atlas_->faces.setPage(at.layer, at.place, {});
    atlas_->faces.setPage(entry.layer, entry.place, at);
    chain.push_back(*page);
    return page;
}

void CubeMapProjector::releasePages() {
    for (const auto& [tile, pages] : pages_) {
        release(tile, pages);
    }
    pages_.clear();
}

void CubeMapProjector::releasePages(int tile) {
    if (const auto found = pages_.find(tile); found != pages_.end()) {
        release(tile, found->second);
        pages_.erase(found);
    }
}

void CubeMapProjector::releasePages(const Bounds& region) {
    std::erase_if(pages_, [&](const auto& entry) {
        const bool hit = looksAt(entry.first, region);
        if (hit) {
            release(entry.first, entry.second);
        }
        return hit;
    });
}

void CubeMapProjector::release(int tile, const std::vector<int>& pages) {
    const TileTable::Region region = tiles_.region(tile);
    if (hasFace(region.face)) {
        atlas_->faces.setPage(layer(region.face), glm::ivec2(region.x, region.y) / TileTable::kTile,
                              {});
    }
    for (const int page : pages) {
        atlas_->pages.release(page);
    }
    tiles_.setPagePasses(tile, 0);
}

bool CubeMapProjector::looksAt(int tile, const Bounds& region) const {
    // Outside where all of the region lies beyond one of the four planes through the tile's edges.
    const TileTable::Region t = tiles_.region(tile);
    const float perTexel = 2.0F / static_cast<float>(tiles_.faceSize());
    const glm::vec2 low = perTexel * glm::vec2(t.x, t.y) - 1.0F;
    const glm::vec2 high = perTexel * glm::vec2(t.x + t.width, t.y + t.height) - 1.0F;
    std::array<bool, 4> beyond{true, true, true, true};
    for (unsigned corner = 0; corner < 8; ++corner) {
        const glm::vec3 p = shared::toFace(t.face, region.corner(corner) - position_);
        beyond[0] = beyond[0] && p.x < low.x * p.z;
        beyond[1] = beyond[1] && p.x > high.x * p.z;
        beyond[2] = beyond[2] && p.y < low.y * p.z;
        beyond[3] = beyond[3] && p.y > high.y * p.z;
    }
    return std::ranges::find(beyond, true) == beyond.end();
}

std::vector<int> CubeMapProjector::tilesTowards(const Bounds& region) const {
    const auto size = static_cast<float>(tiles_.faceSize());
    std::vector<int> found;
    if (!isFinite(region.min) || !isFinite(region.max)) {
        found.resize(region.empty() ? 0 : static_cast<std::size_t>(tiles_.count()));
        std::iota(found.begin(), found.end(), 0);
        return found;
    }
    for (int face = 0; face < kFaces; ++face) {
        glm::vec2 low(size);
        glm::vec2 high(0.0F);
        int before = 0; // corners that lie before the face
        for (unsigned corner = 0; corner < 8; ++corner) {
            const glm::vec3 p = shared::toFace(face, region.corner(corner) - position_);
            const glm::vec2 at = (glm::vec2(p) / p.z + 1.0F) * (0.5F * size);
            if (p.z > 0.0F && std::isfinite(at.x) && std::isfinite(at.y)) {
                ++before;
                low = glm::min(low, at);
                high = glm::max(high, at);
            }
        }
        const bool whole = before == 8;
        for (const int tile : before == 0 ? std::vector<int>()
                              : whole     ? tiles_.within(face, low, high)
                                          : tiles_.within(face, glm::vec2(0.0F), glm::vec2(size))) {
            if (whole || looksAt(tile, region)) {
                found.push_back(tile);
            }
        }
    }
    return found;
}

int CubeMapProjector::facesAllocated() const {
    return static_cast<int>(
        std::count_if(layers_.begin(), layers_.end(), [](int layer) { return layer != kNoLayer; }));
}

CubeMapImage CubeMapProjector::read(const gl::Functions& gl) const {
    const int size = tiles_.faceSize();
    const auto count = static_cast<std::size_t>(kFaces * size * size);
    CubeMapImage image{size, position_, std::vector<float>(count, 1.0F),
                       std::vector<float>(count, -1.0F)};
    const auto rows = static_cast<std::size_t>(size);
    std::vector<float> face(rows * rows);
    for (int f = 0; f < kFaces; ++f) {
        for (int which = 0; hasFace(f) && which < 2; ++which) {
            atlas_->faces.bindForReading(layer(f), which);
            gl::usePixels(gl);
            gl.ReadPixels(0, 0, size, size, GL_RED, GL_FLOAT, face.data());
            std::vector<float>& into = which == 0 ? image.visibility : image.distance;
            for (std::size_t i = 0; i < face.size(); ++i) {
                const std::size_t x = i % rows;
                const std::size_t y = i / rows;
                float value = face[i];
                if (which == 1) {
                    const glm::vec2 uv = (glm::vec2(x, y) + 0.5F) / static_cast<float>(size);
                    value = value > 0.0F ? shared::decodeDistance(value, depthCode_) *
                                               glm::length(shared::faceDirection(f, uv))
                                         : -1.0F;
                }
                into[(y * kFaces + static_cast<std::size_t>(f)) * rows + x] = value;
            }
        }
    }
    return image;
}

CubeMapInfo CubeMapProjector::info() {
    return {.id = id_,
            .position = position_,
            .faceSize = tiles_.faceSize(),
            .facesModelled = facesAllocated(),
            .layers = captured_,
            .bytes = static_cast<std::size_t>(facesAllocated()) * atlas_->faces.bytesPerFace(),
            .captureBytes = captureBytes_,
            .buildMs = buildMs_,
            .buildGpuMs = timer_.milliseconds()};
}

} // namespace aolib
