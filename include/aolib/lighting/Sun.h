#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include <aolib/LightingExport.h>
#include <aolib/lighting/EnvironmentMap.h>

namespace aolib::lighting {

/// A small bright source; the host draws it as a directional light with a shadow.
struct Sun {
    glm::vec3 direction{0.0F, 1.0F, 0.0F}; ///< towards the sun, unit length
    glm::vec3 irradiance{0.0F}; ///< of a surface facing the sun, the map's unit times steradians
    float radius = 0.0F;        ///< of a disc with the sun's solid angle, radians
};

/// A map that is split into a sun and the rest.
struct SplitEnvironment {
    std::optional<Sun> sun;
    EnvironmentMap rest; ///< the map without the sun; the whole map if no sun is found
};

/// Splits a map into its sun and the rest. A shadow map resolves whether so small a source is
/// hidden; a cone of open directions does not (GPU Gems, chapter 17.5).
///
/// The sun's texels lie within 5 degrees of the brightest texel and have at least a tenth of its
/// brightness. No sun is found if such bright texels also lie 5 to 8 degrees away, or if the sun
/// gives less than a fifth of the map's light.
/// In `rest`, the mean radiance of the ring from 5 to 8 degrees limits the sun's texels.
/// Precondition: the map passes checkEnvironment(). Since 0.1.
AOLIB_LIGHTING_EXPORT SplitEnvironment splitSun(EnvironmentMap map);

/// Computes the outgoing radiance of a white diffuse surface due to a visible sun, in the map's
/// unit.
/// @param normal  the surface's normal, unit length.
AOLIB_LIGHTING_EXPORT glm::vec3 sunLight(const Sun& sun, const glm::vec3& normal);

} // namespace aolib::lighting
