#include "content/generated/SolidBuilder.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "content/generated/PositionWeld.h"

namespace aolib {
namespace {

constexpr float smallestDoubledArea = 1e-7F;
constexpr float creaseCosine = 0.82F; ///< cos 35 degrees
constexpr float weldDistance = 1e-4F;

} // namespace

glm::vec3 Frame::at(const glm::vec2& p, float depth) const {
    return origin + u * p.x + v * p.y - glm::cross(u, v) * depth;
}

Outline rectangle(const glm::vec2& low, const glm::vec2& high) {
    return {low, {high.x, low.y}, high, {low.x, high.y}};
}

Outline roundArch(const glm::vec2& low, const glm::vec2& high, int segments) {
    const float radius = 0.5F * (high.x - low.x);
    const glm::vec2 centre{low.x + radius, high.y - radius};
    Outline outline{low, {high.x, low.y}};
    for (int i = 0; i <= segments; ++i) {
        const float angle = glm::pi<float>() * static_cast<float>(i) / static_cast<float>(segments);
        outline.push_back(centre + radius * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    return outline;
}

Outline pointedArch(const glm::vec2& low, float width, float springing, int segments) {
    Outline outline{low, {low.x + width, low.y}};
    const float last = glm::pi<float>() / 3.0F;
    for (int i = 0; i <= segments; ++i) {
        const float angle = last * static_cast<float>(i) / static_cast<float>(segments);
        outline.push_back(glm::vec2(low.x, springing) +
                          width * glm::vec2(std::cos(angle), std::sin(angle)));
    }
    for (int i = segments - 1; i >= 0; --i) {
        const float angle = last * static_cast<float>(i) / static_cast<float>(segments);
        outline.push_back(glm::vec2(low.x + width, springing) +
                          width * glm::vec2(-std::cos(angle), std::sin(angle)));
    }
    return outline;
}

Outline regularPolygon(float radius, int corners, float firstAngle) {
    Outline outline;
    for (int i = 0; i < corners; ++i) {
        const float angle =
            firstAngle + glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(corners);
        outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return outline;
}

std::uint32_t SolidBuilder::addVertex(const glm::vec3& position, const glm::vec3& normal) {
    mesh_.positions.emplace_back(place_ * glm::vec4(position, 1.0F));
    mesh_.normals.push_back(glm::normalize(glm::mat3(place_) * normal));
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
}

void SolidBuilder::triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 normal = glm::cross(b - a, c - a);
    if (glm::length(normal) <= smallestDoubledArea) {
        return;
    }
    for (const glm::vec3& p : {a, b, c}) {
        mesh_.indices.push_back(addVertex(p, normal));
    }
}

void SolidBuilder::polygon(const std::vector<glm::vec3>& corners) {
    for (std::size_t i = 2; i < corners.size(); ++i) {
        triangle(corners[0], corners[i - 1], corners[i]);
    }
}

void SolidBuilder::quad(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
                        const glm::vec3& d) {
    polygon({a, b, c, d});
}

void SolidBuilder::face(const Frame& frame, const Outline& outline,
                        const std::vector<Outline>& holes, float depth, bool reversed) {
    const glm::vec3 front = glm::cross(frame.u, frame.v);
    const auto base = static_cast<std::uint32_t>(mesh_.positions.size());
    const auto addRing = [&](const Outline& ring) {
        for (const glm::vec2& p : ring) {
            addVertex(frame.at(p, depth), reversed ? -front : front);
        }
    };
    addRing(outline);
    for (const Outline& hole : holes) {
        addRing(hole);
    }
    for (const std::array<std::size_t, 3>& corners : triangulate(outline, holes)) {
        const std::array<std::size_t, 3> order =
            reversed ? std::array<std::size_t, 3>{0, 2, 1} : std::array<std::size_t, 3>{0, 1, 2};
        for (const std::size_t i : order) {
            mesh_.indices.push_back(base + static_cast<std::uint32_t>(corners[i]));
        }
    }
}

void SolidBuilder::strip(const Frame& frame, const Outline& outline, float from, float to,
                         bool inwards) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        glm::vec2 p = outline[i];
        glm::vec2 q = outline[(i + 1) % outline.size()];
        if (inwards) {
            std::swap(p, q);
        }
        quad(frame.at(p, to), frame.at(q, to), frame.at(q, from), frame.at(p, from));
    }
}

void SolidBuilder::panel(const Frame& frame, const Outline& outline,
                         const std::vector<Opening>& openings) {
    std::vector<Outline> holes;
    for (const Opening& opening : openings) {
        holes.push_back(opening.outline);
        if (!opening.through) {
            strip(frame, opening.outline, 0.0F, opening.depth, true);
            face(frame, opening.outline, {}, opening.depth, false);
        }
    }
    face(frame, outline, holes, 0.0F, false);
}

void SolidBuilder::slab(const Frame& frame, const Outline& outline, float thickness,
                        const std::vector<Opening>& openings) {
    panel(frame, outline, openings);
    strip(frame, outline, 0.0F, thickness, false);
    std::vector<Outline> holes;
    for (const Opening& opening : openings) {
        if (opening.through) {
            holes.push_back(opening.outline);
            strip(frame, opening.outline, 0.0F, thickness, true);
        }
    }
    face(frame, outline, holes, thickness, true);
}

void SolidBuilder::box(const glm::vec3& low, const glm::vec3& high) {
    prism(rectangle({low.x, -high.z}, {high.x, -low.z}), low.y, high.y);
}

void SolidBuilder::prism(const Outline& outline, float bottom, float top) {
    const Frame frame{{0.0F, top, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -1.0F}};
    slab(frame, outline, top - bottom);
}

void SolidBuilder::frustum(const glm::vec2& lowHalf, const glm::vec2& highHalf, float bottom,
                           float top) {
    std::array<glm::vec3, 4> low;
    std::array<glm::vec3, 4> high;
    const std::array<glm::vec2, 4> signs{{{-1, 1}, {1, 1}, {1, -1}, {-1, -1}}};
    for (std::size_t i = 0; i < 4; ++i) {
        low[i] = {signs[i].x * lowHalf.x, bottom, signs[i].y * lowHalf.y};
        high[i] = {signs[i].x * highHalf.x, top, signs[i].y * highHalf.y};
    }
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t next = (i + 1) % 4;
        quad(low[i], low[next], high[next], high[i]);
    }
    quad(high[0], high[1], high[2], high[3]);
    quad(low[3], low[2], low[1], low[0]);
}

void SolidBuilder::surface(const std::vector<std::vector<glm::vec3>>& rows, bool wrapRows,
                           bool wrapColumns) {
    const std::size_t columns = rows.front().size();
    const std::size_t quadRows = wrapRows ? rows.size() : rows.size() - 1;
    const std::size_t quadColumns = wrapColumns ? columns : columns - 1;
    const auto at = [&](std::size_t row, std::size_t column) -> const glm::vec3& {
        return rows[row % rows.size()][column % columns];
    };
    std::vector<glm::vec3> faces(quadRows * quadColumns);
    for (std::size_t r = 0; r < quadRows; ++r) {
        for (std::size_t c = 0; c < quadColumns; ++c) {
            faces[r * quadColumns + c] =
                glm::cross(at(r + 1, c + 1) - at(r, c), at(r, c + 1) - at(r + 1, c)) * -1.0F;
        }
    }
    /// The mean of those faces about a corner that belong to the same smooth piece.
    const auto cornerNormal = [&](std::size_t row, std::size_t column, const glm::vec3& own) {
        glm::vec3 sum(0.0F);
        for (std::size_t i = 0; i < 4; ++i) {
            std::size_t r = row + i / 2;
            std::size_t c = column + i % 2;
            if ((!wrapRows && (r == 0 || r > quadRows)) ||
                (!wrapColumns && (c == 0 || c > quadColumns))) {
                continue;
            }
            r = (r + quadRows - 1) % quadRows;
            c = (c + quadColumns - 1) % quadColumns;
            const glm::vec3& face = faces[r * quadColumns + c];
            if (glm::dot(face, own) > creaseCosine * glm::length(face) * glm::length(own)) {
                sum += face;
            }
        }
        return glm::length(sum) > 0.0F ? glm::normalize(sum) : glm::normalize(own);
    };
    std::vector<std::vector<std::uint32_t>> known(rows.size() * columns);
    const auto vertex = [&](std::size_t row, std::size_t column, const glm::vec3& own) {
        const glm::vec3 normal = cornerNormal(row, column, own);
        const glm::vec3 placed = glm::normalize(glm::mat3(place_) * normal);
        auto& candidates = known[(row % rows.size()) * columns + column % columns];
        for (const std::uint32_t index : candidates) {
            if (glm::dot(mesh_.normals[index], placed) > 0.9999F) {
                return index;
            }
        }
        candidates.push_back(addVertex(at(row, column), normal));
        return candidates.back();
    };
    const auto add = [&](const std::array<std::array<std::size_t, 2>, 3>& corners,
                         const glm::vec3& own) {
        std::array<glm::vec3, 3> p;
        for (std::size_t i = 0; i < 3; ++i) {
            p[i] = at(corners[i][0], corners[i][1]);
        }
        if (glm::length(glm::cross(p[1] - p[0], p[2] - p[0])) > smallestDoubledArea) {
            for (const auto& corner : corners) {
                mesh_.indices.push_back(vertex(corner[0], corner[1], own));
            }
        }
    };
    for (std::size_t r = 0; r < quadRows; ++r) {
        for (std::size_t c = 0; c < quadColumns; ++c) {
            const glm::vec3& own = faces[r * quadColumns + c];
            add({{{r, c}, {r, c + 1}, {r + 1, c + 1}}}, own);
            add({{{r, c}, {r + 1, c + 1}, {r + 1, c}}}, own);
        }
    }
}

void SolidBuilder::lathe(const Outline& profile, int segments, bool loop) {
    std::vector<std::vector<glm::vec3>> rows;
    for (const glm::vec2& p : profile) {
        rows.emplace_back();
        for (int i = 0; i < segments; ++i) {
            const float angle =
                glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(segments);
            rows.back().emplace_back(p.x * std::cos(angle), p.y, -p.x * std::sin(angle));
        }
    }
    surface(rows, loop, true);
}

void SolidBuilder::sweep(const Outline& profile, const std::vector<Station>& path,
                         bool closedPath) {
    const Station& first = path.front();
    const bool forward =
        glm::dot(path[1].centre - first.centre, glm::cross(first.across, first.out)) > 0.0F;
    std::vector<std::vector<glm::vec3>> rows;
    for (std::size_t i = 0; i < path.size(); ++i) {
        const Station& station = path[forward ? i : path.size() - 1 - i];
        rows.emplace_back();
        for (const glm::vec2& p : profile) {
            rows.back().push_back(station.centre + station.across * p.x + station.out * p.y);
        }
    }
    surface(rows, closedPath, true);
    if (!closedPath) {
        const Station& start = forward ? path.front() : path.back();
        const Station& end = forward ? path.back() : path.front();
        face({start.centre, start.across, start.out}, profile, {}, 0.0F, true);
        face({end.centre, end.across, end.out}, profile, {}, 0.0F, false);
    }
}

ModelMesh SolidBuilder::finish(std::string name, const glm::vec3& colour) {
    ModelMesh mesh = std::exchange(mesh_, ModelMesh());
    weldPositions(mesh.positions, weldDistance);
    mesh.name = std::move(name);
    mesh.baseColour = glm::vec4(colour, 1.0F);
    return mesh;
}

} // namespace aolib
