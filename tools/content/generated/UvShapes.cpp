#include "content/generated/UvShapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace aolib {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// Adds a grid of vertices, `make(u, v)` filling one, and two triangles per cell that is not
/// collapsed at a pole.
template <typename Make>
void addGrid(UvMesh& mesh, int columns, int rows, const UvRect& rect, bool poles,
             const Make& make) {
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    const auto stride = static_cast<std::uint32_t>(columns) + 1;
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            const glm::vec2 uv(float(column) / float(columns), float(row) / float(rows));
            const auto [position, normal] = make(uv);
            mesh.positions.push_back(position);
            mesh.normals.push_back(normal);
            mesh.uvs.push_back(glm::mix(rect.low, rect.high, uv));
        }
    }
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t a = base + static_cast<std::uint32_t>(row) * stride +
                                    static_cast<std::uint32_t>(column);
            if (!poles || row > 0) {
                mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + stride + 1});
            }
            if (!poles || row + 1 < rows) {
                mesh.indices.insert(mesh.indices.end(), {a, a + stride + 1, a + stride});
            }
        }
    }
}

/// The direction of a longitude and latitude, from the lower pole to the upper one.
glm::vec3 onSphere(const glm::vec2& uv) {
    const float longitude = 2.0F * pi * (uv.x >= 1.0F ? 0.0F : uv.x); // the seam closes exactly
    const float latitude = pi * (uv.y - 0.5F);
    const bool pole = uv.y <= 0.0F || uv.y >= 1.0F;
    const float across = pole ? 0.0F : std::cos(latitude);
    return {across * std::cos(longitude), std::sin(latitude), -across * std::sin(longitude)};
}

/// Height of the bumps above the unit sphere: ridges around craters of three sizes.
float bump(const glm::vec3& d) {
    float height = 0.0F;
    for (const float frequency : {3.0F, 7.0F, 17.0F}) {
        const glm::vec3 wave = glm::sin(d * (frequency * pi) + frequency);
        height += 0.5F * wave.x * wave.y * wave.z / frequency;
    }
    return height;
}

glm::vec3 onBumpySphere(const glm::vec2& uv) {
    const glm::vec3 d = onSphere(uv);
    return d * (1.0F + bump(d));
}

struct BoxShape {
    glm::vec3 low;
    glm::vec3 high;
    int cells; ///< along a side
    bool inwards;
};

/// One of the six sides: two for each axis, the lower one first.
void addBoxSide(UvMesh& mesh, const BoxShape& box, int side, const UvRect& rect) {
    const int axis = side / 2;
    const bool upper = side % 2 == 1;
    const glm::vec3 size = box.high - box.low;
    glm::vec3 across(0.0F);
    glm::vec3 along(0.0F);
    across[(axis + 1) % 3] = size[(axis + 1) % 3];
    along[(axis + 2) % 3] = size[(axis + 2) % 3];
    glm::vec3 corner = box.low;
    corner[axis] = upper ? box.high[axis] : box.low[axis];
    if (upper == box.inwards) {
        std::swap(across, along);
    }
    addUvQuad(mesh, corner, across, along, box.cells, rect);
}

} // namespace

void addUvQuad(UvMesh& mesh, const glm::vec3& corner, const glm::vec3& across,
               const glm::vec3& along, int cells, const UvRect& rect) {
    const glm::vec3 normal = glm::normalize(glm::cross(across, along));
    addGrid(mesh, cells, cells, rect, false, [&](const glm::vec2& uv) {
        return std::pair(corner + uv.x * across + uv.y * along, normal);
    });
}

void addUvSphere(UvMesh& mesh, const glm::vec3& centre, float radius, int segments, int rings,
                 const UvRect& rect) {
    addGrid(mesh, segments, rings, rect, true, [&](const glm::vec2& uv) {
        const glm::vec3 d = onSphere(uv);
        return std::pair(centre + radius * d, d);
    });
}

void addUvBox(UvMesh& mesh, const glm::vec3& low, const glm::vec3& high, int cells,
              const UvRect& rect, bool inwards, bool lid) {
    constexpr float gap = 0.06F; // of a chart's own place
    const glm::vec2 cell = (rect.high - rect.low) / glm::vec2(3.0F, 2.0F);
    for (int side = 0; side < 6; ++side) {
        const int axis = side / 2;
        if (!lid && axis == 1 && side % 2 == 1) {
            continue;
        }
        const glm::vec2 origin = rect.low + cell * glm::vec2(axis, side % 2);
        addBoxSide(mesh, {low, high, cells, inwards}, side,
                   {origin + gap * cell, origin + (1.0F - gap) * cell});
    }
}

/// A box whose sides lie so far apart in the map that they stay apart in its mipmaps: in places of
/// powers of two, so that a mipmap's texel is one side's until a side is a few of them wide.
UvMesh mipmapBox() {
    const glm::vec2 cell(0.25F, 0.5F);
    const glm::vec2 gap(0.0575F, 0.055F); // of the map, to every side
    UvMesh mesh;
    for (int side = 0; side < 6; ++side) {
        const glm::vec2 origin = cell * glm::vec2(side / 2, side % 2);
        addBoxSide(mesh, {glm::vec3(-1.0F), glm::vec3(1.0F), 4, false}, side,
                   {origin + gap, origin + cell - gap});
    }
    return mesh;
}

UvMesh bumpySphere(int triangles) {
    // Two columns per row; each row has two triangles a column.
    const int rings = std::max(3, static_cast<int>(std::lround(std::sqrt(triangles / 4.0))));
    UvMesh mesh;
    addGrid(mesh, 2 * rings, rings, {{0.01F, 0.01F}, {0.99F, 0.99F}}, true,
            [](const glm::vec2& uv) { return std::pair(onBumpySphere(uv), glm::vec3(0.0F)); });
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 d = glm::normalize(mesh.positions[i]);
        // The gradient of the height, by differences across the sphere.
        const glm::vec3 helper = std::abs(d.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
        const glm::vec3 t = glm::normalize(glm::cross(helper, d));
        const glm::vec3 b = glm::cross(d, t);
        constexpr float step = 1e-3F;
        const auto at = [](const glm::vec3& v) {
            const glm::vec3 unit = glm::normalize(v);
            return unit * (1.0F + bump(unit));
        };
        mesh.normals[i] = glm::normalize(
            glm::cross(at(d + step * t) - at(d - step * t), at(d + step * b) - at(d - step * b)));
    }
    return mesh;
}

std::vector<std::string> uvShapeNames() {
    return {"uv-sphere", "uv-box", "uv-shapes"};
}

UvMesh uvShape(std::string_view name) {
    UvMesh mesh;
    if (name == "uv-sphere") {
        addUvSphere(mesh, glm::vec3(0.0F), 1.0F, 64, 32, {{0.01F, 0.01F}, {0.99F, 0.99F}});
    } else if (name == "uv-box") {
        mesh = mipmapBox();
    } else if (name == "uv-shapes") {
        addUvSphere(mesh, {0.0F, -0.35F, 0.0F}, 0.6F, 64, 32, {{0.01F, 0.51F}, {0.99F, 0.99F}});
        // Walls with a thickness: all of it is closed.
        addUvBox(mesh, glm::vec3(-1.0F), glm::vec3(1.0F), 8, {{0.0F, 0.0F}, {0.5F, 0.5F}}, true,
                 false);
        addUvBox(mesh, glm::vec3(-1.1F), glm::vec3(1.1F, 1.0F, 1.1F), 8,
                 {{0.5F, 0.0F}, {1.0F, 0.5F}}, false, false);
        const auto rim = [&](const glm::vec3& corner, const glm::vec3& across,
                             const glm::vec3& along, const UvRect& rect) {
            addUvQuad(mesh, corner, across, along, 1, rect);
        };
        // In the two places that the lids have left.
        rim({-1.1F, 1.0F, 1.0F}, {0.0F, 0.0F, 0.1F}, {2.2F, 0.0F, 0.0F},
            {{0.175F, 0.26F}, {0.195F, 0.49F}});
        rim({-1.1F, 1.0F, -1.1F}, {0.0F, 0.0F, 0.1F}, {2.2F, 0.0F, 0.0F},
            {{0.215F, 0.26F}, {0.235F, 0.49F}});
        rim({-1.1F, 1.0F, -1.0F}, {0.0F, 0.0F, 2.0F}, {0.1F, 0.0F, 0.0F},
            {{0.675F, 0.26F}, {0.825F, 0.28F}});
        rim({1.0F, 1.0F, -1.0F}, {0.0F, 0.0F, 2.0F}, {0.1F, 0.0F, 0.0F},
            {{0.675F, 0.3F}, {0.825F, 0.32F}});
    }
    return mesh;
}

} // namespace aolib
