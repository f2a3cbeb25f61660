#pragma once

#include <functional>

#include <aolib/lighting/EnvironmentMap.h>

namespace aolib::lighting::test {

/// A map with the radiance of each texel's middle.
EnvironmentMap mapOf(int width, int height,
                     const std::function<glm::vec3(const glm::vec3& direction)>& radiance);

/// The same everywhere.
EnvironmentMap evenSky(float radiance, int width = 64, int height = 32);

/// 1 above the horizon, 0 below.
EnvironmentMap upperSky();

} // namespace aolib::lighting::test
