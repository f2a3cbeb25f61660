#include "bake/gpu/BakeVertices.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "bake/maps/Facets.h"
#include "bake/maps/TexelRaster.h"
#include "gl/Label.h"
#include "scene/Finite.h"

namespace aolib::bake {

namespace {

constexpr std::size_t trianglesAtOnce = 8192;

struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec4 place;
};

class Filler {
public:
    Filler(const BakeFrame& frame, const glm::dvec2& mapSize, const Facets* facets)
        : frame_(frame), size_(mapSize), facets_(facets) {}

    void add(const Surface& surface, std::size_t number) {
        const auto base = static_cast<std::uint32_t>(vertices.size());
        for (std::size_t i = 0; i < surface.positions.size(); ++i) {
            vertices.push_back(vertex(surface, i));
            if (facets_ != nullptr) {
                vertices.back().place.w = facets_->ofVertex(number, i);
            }
        }
        const auto triangles = static_cast<std::uint32_t>(surface.indices.size() / 3);
        for (std::uint32_t t = 0; t < triangles; ++t) {
            const std::uint32_t* index = &surface.indices[std::size_t{t} * 3];
            const bool mapped = surface.map >= 0 && uvFault(surface, t, size_) == UvFault::None;
            for (std::size_t k = 0; k < 3; ++k) {
                if (mapped) {
                    indices.push_back(base + index[k]);
                    continue;
                }
                indices.push_back(static_cast<std::uint32_t>(vertices.size()));
                vertices.push_back(vertices[base + index[k]]);
                vertices.back().place = glm::vec4(0.0F, 0.0F, -1.0F, 0.0F);
            }
        }
    }

    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;

private:
    Vertex vertex(const Surface& surface, std::size_t i) const {
        Vertex result{frame_.toFrame(glm::dvec3(surface.positions[i])), glm::vec3(0.0F),
                      glm::vec4(0.0F, 0.0F, static_cast<float>(surface.map), 0.0F)};
        if (!surface.normals.empty() && isFinite(surface.normals[i])) {
            result.normal = surface.normals[i];
        }
        if (!surface.uvs.empty()) {
            const glm::vec3 uv(surface.uvs[i], 0.0F);
            const glm::vec3 safe = isFinite(uv) ? glm::clamp(uv, 0.0F, 1.0F) : glm::vec3(0.0F);
            result.place.x = safe.x;
            result.place.y = safe.y;
        }
        return result;
    }

    const BakeFrame& frame_;
    glm::dvec2 size_;
    const Facets* facets_;
};

void specify(const gl::Functions& gl, GLuint array, GLuint buffer) {
    gl.BindVertexArray(array);
    gl::label(gl, GL_VERTEX_ARRAY, array, "aolib/bake");
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    constexpr std::array<std::size_t, 3> offsets{offsetof(Vertex, position),
                                                 offsetof(Vertex, normal), offsetof(Vertex, place)};
    for (GLuint location = 0; location < offsets.size(); ++location) {
        gl.EnableVertexAttribArray(location);
        gl.VertexAttribPointer(location, location == 2 ? 4 : 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                               reinterpret_cast<const void*>(offsets[location]));
    }
}

} // namespace

Result<BakeVertices> BakeVertices::create(const gl::Functions& gl, const BakeGeometry& geometry,
                                          const BakeFrame& frame, int width, int height,
                                          const Facets* facets, bool kept) {
    Filler filler(frame, {width, height}, facets);
    const std::vector<Surface>& surfaces = geometry.scene().surfaces;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        filler.add(surfaces[i], i);
    }
    if (filler.indices.size() > std::size_t{std::numeric_limits<GLsizei>::max()}) {
        return AoStatus(StatusCode::OutOfMemory, std::to_string(filler.indices.size() / 3) +
                                                     " triangles are more than GL can number");
    }
    BakeVertices result;
    result.gl_ = &gl;
    auto vertices =
        gl::Buffer::create(gl, GL_ARRAY_BUFFER, filler.vertices.size() * sizeof(Vertex),
                           filler.vertices.data(), GL_STATIC_DRAW, "aolib/bake/vertices");
    if (!vertices) {
        return vertices.status();
    }
    // As vertices: the binding of indices belongs to the vertex array that is current.
    auto indices =
        gl::Buffer::create(gl, GL_ARRAY_BUFFER, filler.indices.size() * sizeof(std::uint32_t),
                           filler.indices.data(), GL_STATIC_DRAW, "aolib/bake/indices");
    if (!indices) {
        return indices.status();
    }
    auto name = gl::Container::create(
        gl, gl::Container::kVertexArray, "aolib/bake",
        [buffer = vertices->name()](const gl::Functions& in, GLuint array) -> AoStatus {
            specify(in, array, buffer);
            return {};
        });
    if (!name) {
        return name.status();
    }
    result.name_ = std::move(*name);
    result.vertices_ = std::move(*vertices);
    result.indices_ = std::move(*indices);
    result.indexCount_ = static_cast<GLsizei>(filler.indices.size());
    if (kept) {
        for (const Vertex& vertex : filler.vertices) {
            result.positions_.push_back(vertex.position);
        }
        result.kept_ = std::move(filler.indices);
    }
    return result;
}

void BakeVertices::draw() const {
    gl_->BindVertexArray(name_.name());
    gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    gl_->DrawElements(GL_TRIANGLES, indexCount_, GL_UNSIGNED_INT, nullptr);
}

void BakeVertices::drawNumbered(gl::GLSLShader& shader) const {
    drawNumbered(shader, indices_, {0, static_cast<std::size_t>(indexCount_) / 3});
}

void BakeVertices::drawNumbered(gl::GLSLShader& shader, const gl::Buffer& indices,
                                const TriangleRange& range) const {
    gl_->BindVertexArray(name_.name());
    gl_->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.name());
    for (std::size_t done = 0; done < range.count; done += trianglesAtOnce) {
        const std::size_t count = std::min(trianglesAtOnce, range.count - done);
        shader.set("uFirst", static_cast<int>(done) + 1);
        gl_->DrawElements(
            GL_TRIANGLES, static_cast<GLsizei>(3 * count), GL_UNSIGNED_INT,
            reinterpret_cast<const void*>((range.first + done) * 3 * sizeof(std::uint32_t)));
    }
}

} // namespace aolib::bake
