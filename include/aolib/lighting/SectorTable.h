#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include <aolib/LightingExport.h>
#include <aolib/OpenSectors.h>
#include <aolib/Status.h>
#include <aolib/lighting/EnvironmentMap.h>

namespace aolib::lighting {

/// The sector of a direction, any length but zero.
AOLIB_LIGHTING_EXPORT int sectorOfDirection(const glm::vec3& direction);

/// Size of a SectorTable.
struct SectorTableOptions {
    int columns = 32; ///< of normals along a row, count, 4 to 256
    int rows = 17;    ///< of normals, count, 2 to 256
};

/// What a white diffuse surface that nothing hides sends out because of each sector of an
/// environment, for every normal. Columns and rows are those of a ConeTable. Since 0.1.
class SectorTable {
public:
    /// Sums over every texel of the map (of at most 128 rows; finer ones are averaged first).
    /// Errors: InvalidOption, those of checkEnvironment().
    AOLIB_LIGHTING_EXPORT static Result<SectorTable> create(const EnvironmentMap& map,
                                                            const SectorTableOptions& options = {});

    /// @param sector  0 to 23. @param normal  any length but zero.
    AOLIB_LIGHTING_EXPORT glm::vec3 lookup(int sector, const glm::vec3& normal) const;

    const SectorTableOptions& size() const { return size_; }
    /// By sector, then row (from the bottom), then column.
    const std::vector<glm::vec3>& values() const { return values_; }

private:
    SectorTableOptions size_;
    std::vector<glm::vec3> values_;
};

/// The radiance of a white diffuse surface under an environment, by how open each sector is; shares
/// are cut to 0 and 1. Since 0.1.
AOLIB_LIGHTING_EXPORT glm::vec3 sectorLight(const SectorTable& sectors, const glm::vec3& normal,
                                            const OpenSectors& open);

} // namespace aolib::lighting
