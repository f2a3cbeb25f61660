#include "bake/maps/CheckOptions.h"

#include <cmath>
#include <string>

namespace aolib::bake {

namespace {

/// The first option out of its range, and no more.
class Check {
public:
    template <typename T>
    Check& within(const char* name, T value, T least, T most) {
        if (status_ && !(value >= least && value <= most)) {
            status_ = {StatusCode::InvalidOption,
                       std::string(name) + " is " + std::to_string(value) + ", must be " +
                           std::to_string(least) + " to " + std::to_string(most)};
        }
        return *this;
    }
    const AoStatus& status() const { return status_; }

private:
    AoStatus status_;
};

constexpr float longest = 1e30F;

} // namespace

AoStatus check(const RayOptions& options) {
    return Check()
        .within("rays", options.rays, 1, 1 << 20)
        .within("radius", options.radius, 0.0F, longest)
        .within("threads", options.threads, 0, 1024)
        .status();
}

AoStatus check(const ScatterOptions& options) {
    return Check()
        .within("directions", options.directions, 1, 1 << 20)
        .within("radius", options.radius, 0.0F, longest)
        .within("rasterSize", options.rasterSize, options.rasterSize == 0 ? 0 : 64, 16384)
        .within("pointSize", options.pointSize, 0.0F, 16.0F)
        .status();
}

AoStatus check(const ShadowOptions& options) {
    return Check()
        .within("directions", options.directions, 1, 1 << 20)
        .within("radius", options.radius, 0.0F, longest)
        .within("depthSize", options.depthSize, 64, 8192)
        .within("mapsPerPass", options.mapsPerPass, 1, 16)
        .within("bias", options.bias, 0.0F, 16.0F)
        .status();
}

AoStatus check(const MapOptions& options) {
    const AoStatus status = Check()
                                .within("width", options.width, 1, 16384)
                                .within("height", options.height, 1, 16384)
                                .within("padding", options.padding, 0, 64)
                                .within("texelSamples", options.texelSamples, 1, 64)
                                .status();
    const std::size_t texels =
        static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
    if (status && !options.wanted.empty() && options.wanted.size() != texels) {
        return {StatusCode::InvalidOption, "wanted names " + std::to_string(options.wanted.size()) +
                                               " texels, a map has " + std::to_string(texels)};
    }
    return status;
}

AoStatus check(const VertexOptions& options) {
    return Check()
        .within("smoothness", options.smoothness, 0.0F, 100.0F)
        .within("density", options.density, 1.0F, 256.0F)
        .status();
}

} // namespace aolib::bake
