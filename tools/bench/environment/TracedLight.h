#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <aolib/Status.h>
#include <aolib/lighting/EnvironmentMap.h>

#include "bench/environment/LitScene.h"
#include "content/NamedCamera.h"
#include "image/Image.h"
#include "raytracing/RayScene.h"
#include "reference/EnvironmentTracer.h"

namespace aolib::bench {

/// What the pixels of a view show.
struct LitPixels {
    std::vector<Receiver> receivers;
    std::vector<std::size_t> places;      ///< of the receivers in the picture
    std::vector<std::uint32_t> triangles; ///< that they lie on
};

/// Errors: InvalidCamera.
Result<LitPixels> litPixels(const RayScene& scene, const NamedCamera& camera, int width,
                            int height);

/// A view of a scene under an environment, traced with the scene's own colours.
struct TracedLight {
    LitPixels pixels;
    LightList light;

    /// Puts the traced pixels into a picture of three channels.
    void paint(FloatImage& picture) const;
};

/// Errors: those of RayScene::create(), litPixels() and traceEnvironment().
Result<TracedLight> traceLight(const LitScene& scene, const lighting::EnvironmentMap& map,
                               const NamedCamera& camera, int width, int height, int rays,
                               const LoopProgress& progress = {});

} // namespace aolib::bench
