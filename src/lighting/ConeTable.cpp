#include <aolib/lighting/ConeTable.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "lighting/ConeSums.h"
#include "lighting/DirectionCells.h"
#include "lighting/Reduced.h"
#include "shared/open_cone.h"

namespace aolib::lighting {

namespace {

constexpr int mostRows = 128;

AoStatus check(const ConeTableOptions& options) {
    if (options.columns < 4 || options.columns > 1024 || options.rows < 2 || options.rows > 512 ||
        options.apertures < 2 || options.apertures > 64) {
        return {StatusCode::InvalidOption,
                "a cone table of " + std::to_string(options.columns) + " x " +
                    std::to_string(options.rows) + " directions and " +
                    std::to_string(options.apertures) +
                    " apertures, must be 4 to 1024, 2 to 512 and 2 to 64"};
    }
    return {};
}

} // namespace

Result<ConeTable> ConeTable::create(const EnvironmentMap& map, const ConeTableOptions& options) {
    if (AoStatus status = check(options); !status) {
        return status;
    }
    if (AoStatus status = checkEnvironment(map); !status) {
        return status;
    }
    const EnvironmentMap source = reduced(map, mostRows);
    const ConeSums sums(source);
    ConeTable table;
    table.size_ = options;
    table.values_.reserve(static_cast<std::size_t>(options.columns) *
                          static_cast<std::size_t>(options.rows) *
                          static_cast<std::size_t>(options.apertures));
    // The narrowest cone has the width of a direction's cell.
    const double narrowest = 0.5 * std::numbers::pi / double(options.rows);
    for (int layer = 0; layer < options.apertures; ++layer) {
        const double half = 0.5 * std::numbers::pi * double(layer) / double(options.apertures - 1);
        const double cosine =
            layer == options.apertures - 1 ? 0.0 : std::cos(std::max(half, narrowest));
        for (int y = 0; y < options.rows; ++y) {
            for (int x = 0; x < options.columns; ++x) {
                const glm::vec2 place{(static_cast<float>(x) + 0.5F) /
                                          static_cast<float>(options.columns),
                                      static_cast<float>(y) / static_cast<float>(options.rows - 1)};
                table.values_.push_back(
                    sums.mean(glm::normalize(glm::dvec3(latLongDirection(place))), cosine));
            }
        }
    }
    return table;
}

glm::vec3 ConeTable::lookup(const glm::vec3& axis, float share) const {
    const glm::vec2 place = latLong(axis);
    const Between x = columnsAt(place.x, size_.columns);
    const Between y = stepsAt(place.y, size_.rows);
    const Between layer = stepsAt(shared::coneAperture(share), size_.apertures);
    const auto value = [&](int column, int row, int aperture) {
        return values_[(static_cast<std::size_t>(aperture) * static_cast<std::size_t>(size_.rows) +
                        static_cast<std::size_t>(row)) *
                           static_cast<std::size_t>(size_.columns) +
                       static_cast<std::size_t>(column)];
    };
    const auto slice = [&](int aperture) {
        return glm::mix(
            glm::mix(value(x.lower, y.lower, aperture), value(x.upper, y.lower, aperture), x.part),
            glm::mix(value(x.lower, y.upper, aperture), value(x.upper, y.upper, aperture), x.part),
            y.part);
    };
    return glm::mix(slice(layer.lower), slice(layer.upper), layer.part);
}

glm::vec3 coneLight(const ConeTable& cones, const glm::vec3& normal, const glm::vec3& bentNormal,
                    float visibility) {
    const float share = shared::coneShare(visibility, glm::dot(normal, bentNormal));
    return std::clamp(visibility, 0.0F, 1.0F) * cones.lookup(bentNormal, share);
}

} // namespace aolib::lighting
