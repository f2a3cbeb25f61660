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
    int columns = 64;   ///< directions along a row, count, 4 to 1024
    int rows = 32;      ///< rows of directions, count, 2 to 512
    int apertures = 16; ///< cones per direction, count, 2 to 64
};

/// Mean radiance of an environment within a cone, tabulated by axis and aperture, in the map's
/// unit. The mean is weighted by the cosine of the angle to the axis. Times the visibility, it is
/// the outgoing radiance of a white diffuse surface that sees the environment through the cone. The
/// widest cone is the hemisphere and gives the outgoing radiance of an unoccluded surface.
///
/// Columns are those of an EnvironmentMap. Rows are evenly spaced from straight down to straight
/// up, both included. Half apertures are evenly spaced up to 90 degrees. Lookups interpolate
/// linearly. Since 0.1.
class ConeTable {
public:
    /// Integrates over every texel of the map. Maps of more than 128 rows are averaged first.
    /// Errors: InvalidOption, those of checkEnvironment().
    AOLIB_LIGHTING_EXPORT static Result<ConeTable> create(const EnvironmentMap& map,
                                                          const ConeTableOptions& options = {});

    /// Returns the mean radiance within a cone, in the map's unit.
    /// @param axis   any length but zero.
    /// @param share  the cone's share of the cosine-weighted hemisphere about the axis, 0 to 1: the
    ///               squared sine of the half aperture.
    AOLIB_LIGHTING_EXPORT glm::vec3 lookup(const glm::vec3& axis, float share) const;

    const ConeTableOptions& size() const { return size_; }
    /// Returns the table, ordered by aperture, then row (from the bottom), then column.
    const std::vector<glm::vec3>& values() const { return values_; }

private:
    ConeTableOptions size_;
    std::vector<glm::vec3> values_;
};

/// Computes the outgoing radiance of a white diffuse surface from its baked visibility, in the
/// map's unit.
/// @param normal      the surface's normal, unit length.
/// @param bentNormal  mean unoccluded direction, unit length.
/// @param visibility  W, 0 closed to 1 open; clamped to this range.
/// Since 0.1.
AOLIB_LIGHTING_EXPORT glm::vec3 coneLight(const ConeTable& cones, const glm::vec3& normal,
                                          const glm::vec3& bentNormal, float visibility);

} // namespace aolib::lighting
