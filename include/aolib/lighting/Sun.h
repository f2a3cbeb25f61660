#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include <aolib/LightingExport.h>
#include <aolib/lighting/EnvironmentMap.h>

namespace aolib::lighting {

/// A small bright source, to be drawn as a directional light with a shadow of its own.
struct Sun {
    glm::vec3 direction{0.0F, 1.0F, 0.0F}; ///< towards it, unit length
    glm::vec3 irradiance{0.0F}; ///< on a surface that faces it, the map's unit times steradians
    float radius = 0.0F;        ///< of a disc of its size, radians
};

/// A map taken apart.
struct SplitEnvironment {
    std::optional<Sun> sun;
    EnvironmentMap rest; ///< without it; the whole map where there is none
};

/// Takes the sun out of a map: what a cone of open directions cannot tell, whether so small a
/// source is hidden, a shadow map can (GPU Gems, chapter 17.5: "hard shadows, key lighting").
///
/// The sun is what is at least a tenth as bright as the brightest texel and within 5 degrees of it,
/// if it is no wider and gives at least a fifth of the light of the whole map; in `rest` it is as
/// bright as the ring about it. The map must be good. Since 0.1.
AOLIB_LIGHTING_EXPORT SplitEnvironment splitSun(EnvironmentMap map);

/// What a white diffuse surface sends out because of a sun that is not hidden from it.
AOLIB_LIGHTING_EXPORT glm::vec3 sunLight(const Sun& sun, const glm::vec3& normal);

} // namespace aolib::lighting
