#include "app/BakeToVertices.h"

#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "app/Table.h"

namespace aolib::app {

std::vector<float> componentsOf(const std::vector<glm::vec3>& vectors) {
    std::vector<float> values;
    values.reserve(vectors.size() * 3);
    for (const glm::vec3& v : vectors) {
        values.insert(values.end(), {v.x, v.y, v.z});
    }
    return values;
}

MaybeFailure BakeToVertices::prepare(OutputFiles& /*files*/) {
    if (!flags_.ao.empty() || !flags_.bentNormals.empty() || flags_.out.empty()) {
        return badInput("--target vertex writes a model with -o, and neither --ao nor "
                        "--bent-normals");
    }
    return std::nullopt;
}

AoStatus BakeToVertices::bake(bake::AbstractBaker& baker, const bake::BakeProgress& progress) {
    Result<std::vector<bake::BakedVertices>> baked = baker.bakeVertices(flags_.vertices, progress);
    if (!baked) {
        return baked.status();
    }
    vertices_ = std::move(*baked);
    return {};
}

/// The piece's values as attributes of its primitive.
MaybeFailure BakeToVertices::setVertices(const BakePiece& piece,
                                         const bake::BakedVertices& vertices) {
    const int mesh = input_.edit.ownMesh(piece.origin.node);
    for (BakePiece& other : input_.pieces) {
        if (other.origin.node == piece.origin.node) {
            other.origin.mesh = mesh;
        }
    }
    const int primitive = piece.origin.primitive;
    if (flags_.attribute == VertexAttribute::Color) {
        if (input_.edit.attribute(mesh, primitive, "COLOR_0") >= 0) {
            return badInput(input_.name + ": " + piece.name +
                            " has vertex colours already; --attribute ao keeps them");
        }
        std::vector<float> colours;
        for (const float w : vertices.visibility) {
            colours.insert(colours.end(), {w, w, w});
        }
        input_.edit.setAttribute(mesh, primitive, "COLOR_0", input_.edit.addFloats(colours, 3));
        return std::nullopt;
    }
    // As normals are: the inverse transpose takes them to the world.
    const glm::mat3 toMesh = glm::transpose(glm::mat3(piece.transform));
    std::vector<glm::vec3> normals;
    for (const glm::vec3& world : vertices.bentNormal) {
        const glm::vec3 local = toMesh * world;
        const float length = glm::length(local);
        normals.push_back(length > 0.0F ? local / length : glm::vec3(0.0F, 1.0F, 0.0F));
    }
    input_.edit.setAttribute(mesh, primitive, "_AO", input_.edit.addFloats(vertices.visibility, 1));
    input_.edit.setAttribute(mesh, primitive, "_BENT_NORMAL",
                             input_.edit.addFloats(componentsOf(normals), 3));
    return std::nullopt;
}

Result<std::string, Failure> BakeToVertices::put(OutputFiles& /*files*/) {
    Table table({"piece", "triangles", "vertices", "mean W"});
    for (std::size_t i = 0; i < input_.pieces.size(); ++i) {
        const bake::BakedVertices& vertices = vertices_[i];
        if (MaybeFailure failure = setVertices(input_.pieces[i], vertices)) {
            return *failure;
        }
        double sum = 0.0;
        for (const float w : vertices.visibility) {
            sum += double(w);
        }
        table.add({input_.pieces[i].name, grouped(input_.pieces[i].surface.indices.size() / 3),
                   grouped(vertices.visibility.size()),
                   knownNumber(sum / double(vertices.visibility.size()), 3)});
    }
    return table.text();
}

} // namespace aolib::app
