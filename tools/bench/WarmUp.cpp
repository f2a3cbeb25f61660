#include "bench/WarmUp.h"

#include <algorithm>

namespace aolib::bench {

namespace {

constexpr int kSmallFaces = 16; ///< texels

} // namespace

AoStatus warmUp(AmbientOcclusion& ao, HostedFrames& frames, const Options& options,
                const glm::vec3& place) {
    Options small = options;
    small.cubeMaps.faceSize = std::min(small.cubeMaps.faceSize, kSmallFaces);
    ao.clear();
    if (AoStatus status = ao.setOptions(small); !status) {
        return status;
    }
    if (options.backbone == Backbone::Cubemapped) {
        if (const Result<CubeMapId> id = ao.addCubeMap(place); !id) {
            return id.status();
        }
    }
    if (const Result<FrameTimes> frame = frames.draw(ao); !frame) {
        return frame.status();
    }
    ao.clear();
    return ao.setOptions(options);
}

} // namespace aolib::bench
