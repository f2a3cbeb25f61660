#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <aolib/lighting/EnvironmentMap.h>

namespace aolib::lighting {

/// Integrals of an environment over cones, weighed by the cosine of the angle to the cone's axis.
///
/// In a row of the map a cone is an interval of longitudes, and the cosine is `A + B cos(longitude
/// - axis)`. So sums along rows of radiance, and of radiance times the longitude's cosine and sine,
/// make each row a difference of sums, whatever the aperture.
class ConeSums {
public:
    /// The map must be good.
    explicit ConeSums(const EnvironmentMap& map);

    /// The weighed mean of radiance within a cone; the radiance of its axis where it is too narrow.
    /// @param axis    unit length.
    /// @param cosine  of the half aperture, 0 to 1.
    glm::vec3 mean(const glm::dvec3& axis, double cosine) const;

private:
    struct Row {
        double sine = 0.0;  ///< of its latitude
        double level = 0.0; ///< cosine of its latitude
        double angle = 0.0; ///< steradians of a texel
    };
    /// Radiance and 1, plain and times the longitude's cosine and sine.
    struct Moments {
        glm::dvec4 plain{0.0};
        glm::dvec4 cosine{0.0};
        glm::dvec4 sine{0.0};
    };

    Moments between(std::size_t row, double from, double to) const;
    Moments upTo(std::size_t row, double place) const;

    const EnvironmentMap& map_;
    std::vector<Row> rows_;
    std::vector<Moments> sums_; ///< `width + 1` a row: over the texels before this one
};

} // namespace aolib::lighting
