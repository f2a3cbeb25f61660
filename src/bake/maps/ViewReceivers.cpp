#include "bake/maps/ViewReceivers.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "scene/Finite.h"

namespace aolib::bake {

namespace {

constexpr int mostPixels = 16384;

bool shows(const ViewPixels& view, std::size_t pixel) {
    return view.normals[pixel] != glm::vec3(0.0F);
}

AoStatus check(const ViewPixels& view) {
    if (view.width < 1 || view.width > mostPixels || view.height < 1 || view.height > mostPixels) {
        return {StatusCode::InvalidOption, "a view is " + std::to_string(view.width) + " x " +
                                               std::to_string(view.height) +
                                               " pixels, must be 1 to 16384 each"};
    }
    const std::size_t pixels =
        static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
    if (view.positions.size() != pixels || view.normals.size() != pixels ||
        (!view.planes.empty() && view.planes.size() != pixels)) {
        return {StatusCode::InvalidOption,
                "a view of " + std::to_string(pixels) +
                    " pixels has a position, a normal and a plane for each, or no planes"};
    }
    if (!(view.lift >= 0.0F) || !std::isfinite(view.lift)) {
        return {StatusCode::InvalidOption,
                "lift is " + std::to_string(view.lift) + ", must be 0 or more"};
    }
    return {};
}

} // namespace

Result<std::vector<SurfacePoint>> findReceivers(const ViewPixels& view) {
    if (AoStatus status = check(view); !status) {
        return status;
    }
    std::vector<SurfacePoint> points;
    for (std::size_t i = 0; i < view.normals.size(); ++i) {
        if (!shows(view, i)) {
            continue;
        }
        const std::string pixel = "pixel " + std::to_string(i) + " of the view: ";
        const glm::vec3& own = view.planes.empty() ? view.normals[i] : view.planes[i];
        if (!isFinite(view.positions[i])) {
            return AoStatus(StatusCode::InvalidPosition, pixel + "its position is not finite");
        }
        if (!isFinite(view.normals[i]) || !isFinite(own)) {
            return AoStatus(StatusCode::InvalidNormal, pixel + "a normal is not finite");
        }
        SurfacePoint point;
        point.normal = unitOrZero(glm::dvec3(view.normals[i]));
        const glm::dvec3 plane = unitOrZero(glm::dvec3(own));
        point.plane = plane == glm::dvec3(0.0)              ? point.normal
                      : glm::dot(plane, point.normal) < 0.0 ? -plane
                                                            : plane;
        point.position = glm::dvec3(view.positions[i]) + double{view.lift} * point.plane;
        points.push_back(point);
    }
    return points;
}

BakedMap makePicture(const ViewPixels& view, std::span<const glm::vec4> values) {
    const std::size_t pixels = view.normals.size();
    BakedMap picture{view.width, view.height, std::vector<float>(pixels, -1.0F),
                     std::vector<glm::vec3>(pixels, glm::vec3(0.0F)),
                     std::vector<TexelKind>(pixels, TexelKind::Empty)};
    std::size_t next = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (!shows(view, i)) {
            continue;
        }
        const glm::vec4& value = values[next++];
        const glm::vec3 direction(value.y, value.z, value.w);
        const float length = glm::length(direction);
        picture.visibility[i] = std::clamp(value.x, 0.0F, 1.0F);
        picture.bentNormal[i] =
            length > 0.0F ? direction / length : glm::normalize(view.normals[i]);
        picture.kind[i] = TexelKind::Inside;
    }
    return picture;
}

} // namespace aolib::bake
