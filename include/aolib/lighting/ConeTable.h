#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include <aolib/LightingExport.h>
#include <aolib/Status.h>
#include <aolib/lighting/EnvironmentMap.h>

namespace aolib::lighting {

/// Size of a ConeTable.
struct ConeTableOptions {
    int columns = 64;   ///< of directions along a row, count, 4 to 1024
    int rows = 32;      ///< of directions, count, 2 to 512
    int apertures = 16; ///< of cones, count, 2 to 64
};

/// What a white diffuse surface sends out that sees an environment through a cone, for every axis
/// and aperture: the mean radiance within the cone, weighed by the cosine of the angle to its axis.
/// The widest cone is the hemisphere, for which that is what an open surface sends out.
///
/// Columns are those of an EnvironmentMap; rows are evenly spaced from straight down to straight
/// up, both included; half apertures evenly up to 90 degrees. Between them it is interpolated.
/// Since 0.1.
class ConeTable {
public:
    /// Integrates over every texel of the map (of at most 128 rows; finer ones are averaged first).
    /// Errors: InvalidOption, those of checkEnvironment().
    AOLIB_LIGHTING_EXPORT static Result<ConeTable> create(const EnvironmentMap& map,
                                                          const ConeTableOptions& options = {});

    /// The mean within a cone.
    /// @param axis   any length but zero.
    /// @param share  of the cosine-weighed hemisphere about the axis that the cone takes: the
    ///               squared sine of its half aperture, 0 to 1.
    AOLIB_LIGHTING_EXPORT glm::vec3 lookup(const glm::vec3& axis, float share) const;

    const ConeTableOptions& size() const { return size_; }
    /// By aperture, then row (from the bottom), then column.
    const std::vector<glm::vec3>& values() const { return values_; }

private:
    ConeTableOptions size_;
    std::vector<glm::vec3> values_;
};

/// The radiance of a white diffuse surface under an environment, by what was baked of it.
/// @param normal      of the surface, unit length.
/// @param bentNormal  mean open direction, unit length.
/// @param visibility  W, 0 closed to 1 open; cut to that.
/// Since 0.1.
AOLIB_LIGHTING_EXPORT glm::vec3 coneLight(const ConeTable& cones, const glm::vec3& normal,
                                          const glm::vec3& bentNormal, float visibility);

} // namespace aolib::lighting
