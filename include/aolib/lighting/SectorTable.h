#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include <aolib/LightingExport.h>
#include <aolib/OpenSectors.h>
#include <aolib/Status.h>
#include <aolib/lighting/EnvironmentMap.h>

namespace aolib::lighting {

/// Returns the sector of a direction of any length but zero, 0 to 23, as indexed in OpenSectors.
AOLIB_LIGHTING_EXPORT int sectorOfDirection(const glm::vec3& direction);

/// Size of a SectorTable.
struct SectorTableOptions {
    int columns = 32; ///< normals along a row, count, 4 to 256
    int rows = 17;    ///< rows of normals, count, 2 to 256
};

/// Outgoing radiance of an unoccluded white diffuse surface due to each sector of an environment,
/// tabulated by normal, in the map's unit. Columns and rows are those of a ConeTable. Since 0.1.
class SectorTable {
public:
    /// Sums over every texel of the map. Maps of more than 128 rows are averaged first.
    /// Errors: InvalidOption, those of checkEnvironment().
    AOLIB_LIGHTING_EXPORT static Result<SectorTable> create(const EnvironmentMap& map,
                                                            const SectorTableOptions& options = {});

    /// Returns the outgoing radiance due to one sector, in the map's unit.
    /// @param sector  0 to 23.
    /// @param normal  any length but zero.
    AOLIB_LIGHTING_EXPORT glm::vec3 lookup(int sector, const glm::vec3& normal) const;

    const SectorTableOptions& size() const { return size_; }
    /// Returns the table, ordered by sector, then row (from the bottom), then column.
    const std::vector<glm::vec3>& values() const { return values_; }

private:
    SectorTableOptions size_;
    std::vector<glm::vec3> values_;
};

/// Computes the outgoing radiance of a white diffuse surface, in the map's unit.
/// @param normal  the surface's normal, any length but zero.
/// @param open    unoccluded fraction of each sector; clamped to 0 to 1.
/// Since 0.1.
AOLIB_LIGHTING_EXPORT glm::vec3 sectorLight(const SectorTable& sectors, const glm::vec3& normal,
                                            const OpenSectors& open);

} // namespace aolib::lighting
