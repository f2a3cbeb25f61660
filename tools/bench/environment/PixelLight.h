#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <aolib/Status.h>
#include <aolib/lighting/EnvironmentMap.h>

#include "host/LitRenderer.h"
#include "raytracing/RayScene.h"
#include "reference/OpeningTracer.h"

namespace aolib::bench {

/// Light of receivers from their openings, by a method, as the shaders of the host compute it but
/// on the CPU; the sun's shadow is traced.
Result<std::vector<glm::vec3>> lightOf(const RayScene& scene, std::span<const Receiver> receivers,
                                       std::span<const Opening> openings,
                                       const lighting::EnvironmentMap& map, host::LitMethod method);

} // namespace aolib::bench
