#include "backbone/cubemapped/CubeMapProjector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "shared/cube_faces.h"
#include "shared/distance_code.h"

namespace aolib {

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

void CubeMapProjector::spanDistances(FaceStore& store, float nearest, float farthest) {
    // A depth along a face's axis is a distance divided by at most sqrt(3).
    const float least = nearest / std::numbers::sqrt3_v<float>;
    if (least >= nearest_ && farthest <= farthest_) {
        return;
    }
    dropFaces(store);
    nearest_ = least;
    farthest_ = farthest;
    depthCode_ = shared::distanceSpan(nearest_, farthest_);
}

Status CubeMapProjector::keepFace(FaceStore& store, int face) {
    if (keeps(face)) {
        return {};
    }
    const auto layer = store.takeReserved();
    if (layer) {
        layers_[static_cast<std::size_t>(face)] = *layer;
    }
    return layer.status();
}

Status CubeMapProjector::keepFaces(FaceStore& store, const std::array<bool, kFaces>& modelled) {
    for (int face = 0; face < kFaces; ++face) {
        if (!modelled[static_cast<std::size_t>(face)]) {
            dropFace(store, face);
        } else if (Status status = keepFace(store, face); !status) {
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

Result<int> CubeMapProjector::detailOf(const FaceStore& store, DetailStore& details, int tile) {
    if (const auto found = details_.find(tile); found != details_.end()) {
        return found->second;
    }
    const auto block = details.take();
    if (block) {
        details_.emplace(tile, *block);
        const TileProgress::Region region = tiles.region(tile);
        store.setPage(layer(region.face), region, details.page(*block));
    }
    return block;
}

void CubeMapProjector::dropDetails(const FaceStore& store, DetailStore& details) {
    for (const auto& [tile, block] : details_) {
        const TileProgress::Region region = tiles.region(tile);
        if (keeps(region.face)) {
            store.setPage(layer(region.face), region, {});
        }
        details.giveBack(block);
    }
    details_.clear();
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
