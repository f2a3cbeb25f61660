#include "backbone/texels/FaceCapture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "scene/WorldTriangles.h"
#include "shared/cube_faces.h"

namespace aolib {

namespace {

/// Room left between the planes of the capture and what they must hold, as a share.
constexpr float kRangeSlack = 0.01F;
/// Least nearest distance, as a share of the farthest: keeps the range of a centre on a surface
/// finite.
constexpr float kLeastNearest = 1e-5F;

/// Model to the cube's frame: world axes, origin at its centre. The subtraction is done in double.
glm::mat4 modelToCube(const glm::mat4& model, const glm::dvec3& centre) {
    glm::dmat4 m(model);
    m[3] -= glm::dvec4(centre, 0.0);
    return glm::mat4(m);
}

/// Whether a box reaches into a frustum, as ViewFace has it.
bool reaches(const Bounds& box, const glm::dvec3& centre, const glm::mat3& frustum) {
    std::array<bool, 5> allOutside{true, true, true, true, true};
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p{(corner & 1) != 0 ? box.max.x : box.min.x,
                           (corner & 2) != 0 ? box.max.y : box.min.y,
                           (corner & 4) != 0 ? box.max.z : box.min.z};
        const glm::vec3 v = frustum * glm::vec3(p - centre);
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

} // namespace

glm::mat3 cubeToFace(int face) {
    return glm::transpose(
        glm::mat3(shared::faceRight(face), shared::faceUp(face), shared::faceForward(face)));
}

bool reachesFace(const Bounds& box, const glm::dvec3& centre, int face) {
    return reaches(box, centre, cubeToFace(face));
}

DistanceRange distanceRange(const Scene& scene, const glm::vec3& centre) {
    const float farthest = scene.bounds().farthest(centre);
    const float clearance = scene.clearance(centre).distance;
    return {std::max(clearance, kLeastNearest * farthest) * (1.0F - kRangeSlack),
            farthest * (1.0F + kRangeSlack)};
}

ViewFace ViewFace::of(const HostCamera& camera, const glm::ivec2& size,
                      const ClipConvention& clip) {
    const glm::dmat4& p = camera.projection();
    const double flip = clip.upperLeft ? -1.0 : 1.0;
    const glm::dmat3 rows({p[0][0], 0.0, p[2][0]}, {0.0, flip * p[1][1], flip * p[2][1]},
                          {0.0, 0.0, p[2][3]});
    // Least in the farthest corner.
    const double x = (1.0 + std::abs(p[2][0])) / p[0][0];
    const double y = (1.0 + std::abs(p[2][1])) / p[1][1];
    return {.frustum = glm::mat3(glm::transpose(camera.eyeToWorld() * rows)),
            .leastClip = static_cast<float>(1.0 / std::sqrt(x * x + y * y + 1.0)),
            .size = size};
}

bool FaceCapture::draw(gl::GLSLShader& shader, int face) const {
    const gl::Functions& gl = context_.gl;
    const glm::mat3 frustum = face < kFaces ? cubeToFace(face) : view_->frustum;
    const float leastClip = face < kFaces ? 1.0F / std::numbers::sqrt3_v<float> : view_->leastClip;
    // Right, up and forward are left-handed, unless the host draws upside down.
    const bool mirrored = glm::determinant(frustum) > 0.0F;
    const float near = leastClip * range_.nearest;
    // Without a far plane: what lies far away must not round the depth of what lies near.
    shader.set("uDepthMap", glm::vec2(1.0F, -2.0F * near));
    shader.set("uCubeToFace", frustum);
    gl.Enable(GL_DEPTH_TEST);
    bool drawn = false;
    for (const SceneGeometry::Instance& instance : *instances_) {
        if (!reaches(instance.bounds, centre_, frustum)) {
            continue;
        }
        const gl::VertexArray& triangles = instance.piece->triangles;
        shader.set("uModelToCube", modelToCube(instance.transform, centre_));
        shader.set("uNormalMatrix", glm::mat3(normalMatrix(instance.transform)));
        shader.set("uHasNormals", triangles.hasNormals() ? 1 : 0);
        const bool turned = glm::determinant(glm::mat3(instance.transform)) < 0.0F;
        shader.set("uMirrored", turned != mirrored ? 1 : 0);
        shader.set("uFirstSolid", static_cast<float>(instance.firstSolid));
        triangles.drawTriangles();
        drawn = true;
    }
    gl.Disable(GL_DEPTH_TEST);
    return drawn;
}

} // namespace aolib
