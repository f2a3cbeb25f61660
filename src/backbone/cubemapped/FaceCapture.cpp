#include "backbone/cubemapped/FaceCapture.h"

#include <algorithm>
#include <array>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace aolib {

namespace {

/// Room left between the planes of the capture and what they must hold, as a share.
constexpr float kRangeSlack = 0.01F;
/// Least nearest distance, as a share of the farthest: keeps the range of a centre on a surface
/// finite.
constexpr float kLeastNearest = 1e-5F;

float farthestCorner(const Bounds& box, const glm::vec3& from) {
    return glm::length(glm::max(glm::abs(box.min - from), glm::abs(box.max - from)));
}

/// Model to the cube's frame: world axes, origin at its centre. The subtraction is done in double.
glm::mat4 modelToCube(const glm::mat4& model, const glm::vec3& centre) {
    glm::dmat4 m(model);
    m[3] -= glm::dvec4(glm::dvec3(centre), 0.0);
    return glm::mat4(m);
}

glm::mat3 normalMatrix(const glm::mat4& model) {
    const glm::dmat3 m{glm::dmat4(model)};
    const double determinant = glm::determinant(m);
    return determinant != 0.0 ? glm::mat3(glm::transpose(glm::inverse(m))) : glm::mat3(m);
}

} // namespace

bool reachesFace(const Bounds& box, const glm::vec3& centre, int face) {
    const glm::mat3 toFace = cubeToFace(face);
    std::array<bool, 5> allOutside{true, true, true, true, true};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p{(corner & 1) != 0 ? box.max.x : box.min.x,
                          (corner & 2) != 0 ? box.max.y : box.min.y,
                          (corner & 4) != 0 ? box.max.z : box.min.z};
        const glm::vec3 v = toFace * (p - centre);
        const std::array<bool, 5> outside{v.z <= 0.0F, v.x > v.z, v.x<-v.z, v.y> v.z, v.y < -v.z};
        for (std::size_t i = 0; i < outside.size(); ++i) {
            allOutside[i] = allOutside[i] && outside[i];
        }
    }
    for (const bool plane : allOutside) {
        if (plane) {
            return false;
        }
    }
    return true;
}

DistanceRange distanceRange(const Scene& scene, const glm::vec3& centre) {
    const float farthest = farthestCorner(scene.bounds(), centre);
    const float clearance = scene.clearance(centre).distance;
    return {std::max(clearance, kLeastNearest * farthest) * (1.0F - kRangeSlack),
            farthest * (1.0F + kRangeSlack)};
}

bool FaceCapture::draw(gl::GLSLShader& shader, int face) const {
    const gl::Functions& gl = context_.gl;
    const float near = range_.nearest / std::numbers::sqrt3_v<float>;
    // Without a far plane: what lies far away must not round the depth of what lies near.
    shader.set("uDepthMap", glm::vec2(1.0F, -2.0F * near));
    shader.set("uCubeToFace", cubeToFace(face));
    gl.Enable(GL_DEPTH_TEST);
    bool drawn = false;
    for (const auto& [id, mesh] : context_.scene.meshes()) {
        if (!reachesFace(mesh.worldBounds(), centre(), face)) {
            continue;
        }
        const SceneGeometry::Piece& piece = geometry_.piece(id);
        shader.set("uModelToCube", modelToCube(mesh.transform, centre()));
        shader.set("uNormalMatrix", normalMatrix(mesh.transform));
        shader.set("uHasNormals", piece.triangles.hasNormals() ? 1 : 0);
        shader.set("uMirrored", glm::determinant(glm::mat3(mesh.transform)) < 0.0F ? 1 : 0);
        shader.set("uFirstSolid", static_cast<float>(piece.firstSolid));
        piece.triangles.drawTriangles();
        drawn = true;
    }
    gl.Disable(GL_DEPTH_TEST);
    return drawn;
}

} // namespace aolib
