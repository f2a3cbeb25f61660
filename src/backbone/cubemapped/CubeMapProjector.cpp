#include "backbone/cubemapped/CubeMapProjector.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

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

} // namespace

Result<CubeMapProjector> CubeMapProjector::create(const gl::Functions& gl, CubeMapId id,
                                                  const glm::vec3& position, int faceSize) {
    auto timer = gl::GpuTimer::create(gl);
    if (!timer) {
        return timer.status();
    }
    CubeMapProjector projector;
    projector.id_ = id;
    projector.position_ = position;
    projector.tiles = TileProgress(faceSize);
    projector.timer = std::move(*timer);
    return projector;
}

bool CubeMapProjector::spanDistances(FaceStore& store, BlockStore& blocks, float nearest,
                                     float farthest) {
    // A depth along a face's axis is a distance divided by at most sqrt(3).
    const float least = nearest / std::numbers::sqrt3_v<float>;
    if (least >= nearest_ && farthest <= farthest_) {
        return false;
    }
    const float room = std::isfinite(nearest_) ? kRoomInCode : 1.0F;
    dropBlocks(store, blocks);
    dropFaces(store);
    tiles.forget();
    nearest_ = least < nearest_ ? least / room : nearest_;
    farthest_ = farthest > farthest_ ? farthest * room : farthest_;
    depthCode_ = shared::distanceSpan(nearest_, farthest_);
    return true;
}

AoStatus CubeMapProjector::keepFace(FaceStore& store, int face) {
    if (keeps(face)) {
        return {};
    }
    const auto layer = store.takeReserved();
    if (layer) {
        layers_[static_cast<std::size_t>(face)] = *layer;
    }
    return layer.status();
}

AoStatus CubeMapProjector::keepFaces(FaceStore& store, const std::array<bool, kFaces>& modelled) {
    for (int face = 0; face < kFaces; ++face) {
        if (!modelled[static_cast<std::size_t>(face)]) {
            dropFace(store, face);
        } else if (AoStatus status = keepFace(store, face); !status) {
            return status;
        }
    }
    return {};
}

void CubeMapProjector::dropFace(FaceStore& store, int face) {
    if (keeps(face)) {
        store.giveBackReserved(layer(face));
        layers_[static_cast<std::size_t>(face)] = kNoLayer;
    }
}

void CubeMapProjector::dropFaces(FaceStore& store) {
    for (int face = 0; face < kFaces; ++face) {
        dropFace(store, face);
    }
}

Result<int> CubeMapProjector::blockOf(const FaceStore& store, BlockStore& blocks, int tile) {
    const auto found = blocks_.find(tile);
    return found != blocks_.end() ? found->second.front() : addBlock(store, blocks, tile);
}

Result<int> CubeMapProjector::addBlock(const FaceStore& store, BlockStore& blocks, int tile) {
    const auto block = blocks.take();
    if (!block) {
        return block;
    }
    // Each says where the next one is: the tile's own page, or that of the block before, whose
    // place is a tile's of its layer.
    const TileProgress::Region region = tiles.region(tile);
    FaceStore::Page link{layer(region.face), glm::ivec2(region.x, region.y) / TileProgress::kTile};
    std::vector<int>& chain = blocks_[tile];
    if (!chain.empty()) {
        link = blocks.page(chain.back());
    }
    const FaceStore::Page page = blocks.page(*block);
    store.setPage(page.layer, page.at, {});
    store.setPage(link.layer, link.at, page);
    chain.push_back(*block);
    return block;
}

void CubeMapProjector::dropBlocks(const FaceStore& store, BlockStore& blocks) {
    for (const auto& [tile, dropped] : blocks_) {
        giveBack(store, blocks, tile, dropped);
    }
    blocks_.clear();
}

void CubeMapProjector::dropBlocks(const FaceStore& store, BlockStore& blocks, int tile) {
    if (const auto kept = blocks_.find(tile); kept != blocks_.end()) {
        giveBack(store, blocks, tile, kept->second);
        blocks_.erase(kept);
    }
}

void CubeMapProjector::dropBlocks(const FaceStore& store, BlockStore& blocks,
                                  const Bounds& region) {
    std::erase_if(blocks_, [&](const auto& kept) {
        const bool hit = looksAt(kept.first, region);
        if (hit) {
            giveBack(store, blocks, kept.first, kept.second);
        }
        return hit;
    });
}

void CubeMapProjector::giveBack(const FaceStore& store, BlockStore& blocks, int tile,
                                const std::vector<int>& dropped) {
    const TileProgress::Region region = tiles.region(tile);
    if (keeps(region.face)) {
        store.setPage(layer(region.face), glm::ivec2(region.x, region.y) / TileProgress::kTile, {});
    }
    for (const int block : dropped) {
        blocks.giveBack(block);
    }
    tiles.setBlockPasses(tile, 0);
}

bool CubeMapProjector::looksAt(int tile, const Bounds& region) const {
    // Outside where all of the region lies beyond one of the four planes through the tile's edges.
    const TileProgress::Region t = tiles.region(tile);
    const float perTexel = 2.0F / static_cast<float>(tiles.faceSize());
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
    const auto size = static_cast<float>(tiles.faceSize());
    std::vector<int> found;
    if (!isFinite(region.min) || !isFinite(region.max)) {
        found.resize(region.empty() ? 0 : static_cast<std::size_t>(tiles.count()));
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
                              : whole     ? tiles.within(face, low, high)
                                          : tiles.within(face, glm::vec2(0.0F), glm::vec2(size))) {
            if (whole || looksAt(tile, region)) {
                found.push_back(tile);
            }
        }
    }
    return found;
}

int CubeMapProjector::facesKept() const {
    return static_cast<int>(
        std::count_if(layers_.begin(), layers_.end(), [](int layer) { return layer != kNoLayer; }));
}

CubeMapImage CubeMapProjector::read(const gl::Functions& gl, const FaceStore& store) const {
    const int size = tiles.faceSize();
    const auto count = static_cast<std::size_t>(kFaces * size * size);
    CubeMapImage image{size, position_, std::vector<float>(count, 1.0F),
                       std::vector<float>(count, -1.0F)};
    const auto rows = static_cast<std::size_t>(size);
    std::vector<float> face(rows * rows);
    for (int f = 0; f < kFaces; ++f) {
        for (int which = 0; keeps(f) && which < 2; ++which) {
            store.beginRead(layer(f), which);
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

CubeMapInfo CubeMapProjector::info(const FaceStore& store) {
    return {.id = id_,
            .position = position_,
            .faceSize = tiles.faceSize(),
            .facesModelled = facesKept(),
            .layers = captured,
            .bytes = static_cast<std::size_t>(facesKept()) * store.bytesPerFace(),
            .captureBytes = captureBytes,
            .buildMs = buildMs,
            .buildGpuMs = timer.milliseconds()};
}

} // namespace aolib
