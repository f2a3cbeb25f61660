#include <aolib/lighting/SectorTable.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lighting/DirectionCells.h"
#include "lighting/Reduced.h"
#include "shared/open_sector.h"

namespace aolib::lighting {

static_assert(std::tuple_size_v<OpenSectors> == std::size_t{shared::SECTOR_COUNT});

namespace {

constexpr int mostSectorRows = 128;

AoStatus check(const SectorTableOptions& options) {
    if (options.columns < 4 || options.columns > 256 || options.rows < 2 || options.rows > 256) {
        return {StatusCode::InvalidOption, "a sector table of " + std::to_string(options.columns) +
                                               " x " + std::to_string(options.rows) +
                                               " normals, must be 4 to 256 and 2 to 256"};
    }
    return {};
}

std::vector<glm::vec3> tableNormals(const SectorTableOptions& size) {
    std::vector<glm::vec3> normals;
    for (int y = 0; y < size.rows; ++y) {
        for (int x = 0; x < size.columns; ++x) {
            normals.push_back(glm::normalize(latLongDirection(
                {(float(x) + 0.5F) / float(size.columns), float(y) / float(size.rows - 1)})));
        }
    }
    return normals;
}

} // namespace

int sectorOfDirection(const glm::vec3& direction) {
    return shared::sectorOf(direction);
}

Result<SectorTable> SectorTable::create(const EnvironmentMap& map,
                                        const SectorTableOptions& options) {
    if (AoStatus status = check(options); !status) {
        return status;
    }
    if (AoStatus status = checkEnvironment(map); !status) {
        return status;
    }
    const EnvironmentMap source = reduced(map, mostSectorRows);
    SectorTable table;
    table.size_ = options;
    const std::vector<glm::vec3> normals = tableNormals(options);
    table.values_.assign(normals.size() * shared::SECTOR_COUNT, glm::vec3(0.0F));
    const auto sineOf = [&](int row) {
        return std::sin(std::numbers::pi * (double(row) / double(source.height) - 0.5));
    };
    for (int y = 0; y < source.height; ++y) {
        // Over pi: a white surface sends out its irradiance over pi.
        const auto angle = static_cast<float>(2.0 * (sineOf(y + 1) - sineOf(y)) / source.width);
        for (int x = 0; x < source.width; ++x) {
            const glm::vec3 direction =
                latLongDirection({(float(x) + 0.5F) / float(source.width),
                                  (float(y) + 0.5F) / float(source.height)});
            const glm::vec3 light =
                angle *
                source
                    .radiance[static_cast<std::size_t>(y) * static_cast<std::size_t>(source.width) +
                              static_cast<std::size_t>(x)];
            glm::vec3* values =
                &table.values_[static_cast<std::size_t>(sectorOfDirection(direction)) *
                               normals.size()];
            for (std::size_t i = 0; i < normals.size(); ++i) {
                values[i] += std::max(glm::dot(normals[i], direction), 0.0F) * light;
            }
        }
    }
    return table;
}

glm::vec3 SectorTable::lookup(int sector, const glm::vec3& normal) const {
    const glm::vec2 place = latLong(normal);
    const Between x = columnsAt(place.x, size_.columns);
    const Between y = stepsAt(place.y, size_.rows);
    const auto value = [&](int column, int row) {
        return values_[(static_cast<std::size_t>(sector) * static_cast<std::size_t>(size_.rows) +
                        static_cast<std::size_t>(row)) *
                           static_cast<std::size_t>(size_.columns) +
                       static_cast<std::size_t>(column)];
    };
    return glm::mix(glm::mix(value(x.lower, y.lower), value(x.upper, y.lower), x.part),
                    glm::mix(value(x.lower, y.upper), value(x.upper, y.upper), x.part), y.part);
}

glm::vec3 sectorLight(const SectorTable& sectors, const glm::vec3& normal,
                      const OpenSectors& open) {
    glm::vec3 light(0.0F);
    for (std::size_t k = 0; k < open.size(); ++k) {
        light += std::clamp(open[k], 0.0F, 1.0F) * sectors.lookup(static_cast<int>(k), normal);
    }
    return light;
}

} // namespace aolib::lighting
