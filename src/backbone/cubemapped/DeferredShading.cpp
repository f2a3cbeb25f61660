#include "backbone/cubemapped/DeferredShading.h"

#include <array>
#include <chrono>
#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "backbone/Estimators.h"
#include "backbone/ShaderLibrary.h"
#include "gl/Label.h"

namespace aolib {

namespace {

using Format = gl::RenderToTexture2D::Format;
using Depth = gl::RenderToTexture2D::Depth;

/// Room left between the planes of the capture and what they must hold, as a share.
constexpr float kRangeSlack = 0.01F;

/// Whether a box, relative to the cube's centre, reaches into the frustum of a face. May say yes to
/// a box just outside.
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

Result<DeferredShading> DeferredShading::create(const BackboneContext& context) {
    auto capture = buildShader(context.gl, "cubemap/capture.vert", "cubemap/capture.frag");
    if (!capture) {
        return capture.status();
    }
    DeferredShading shading;
    shading.capture_ = std::move(*capture);
    if (Status status = shading.chooseEstimator(context); !status) {
        return status;
    }
    return shading;
}

Status DeferredShading::chooseEstimator(const BackboneContext& context) {
    const Estimator estimator = context.options.estimator;
    auto shader =
        buildShader(context.gl, "fullscreen.vert",
                    "cubemap/visibility_" + std::string(estimatorShader(estimator)) + ".frag");
    if (shader) {
        visibility_ = std::move(*shader);
        estimator_ = estimator;
    }
    return shader.status();
}

std::size_t DeferredShading::captureBytes(int faceSize) {
    const std::size_t perTexel = gl::RenderToTexture2D::bytesPerTexel(Format::RGBA32F) +
                                 gl::RenderToTexture2D::bytesPerTexel(Depth::Depth32F);
    return perTexel * static_cast<std::size_t>(kFaces * faceSize * faceSize);
}

Status DeferredShading::build(const BackboneContext& context, const SceneGeometry& geometry,
                              float radius, CubeMapProjector& projector) {
    const gl::DebugGroup group(context.gl, "aolib: build a cube map");
    const auto start = std::chrono::steady_clock::now();
    if (context.scene.empty()) {
        return {StatusCode::NoScene, "there are no triangles to place a cube map among; describe a "
                                     "mesh first"};
    }
    if (estimator_ != context.options.estimator) {
        if (Status status = chooseEstimator(context); !status) {
            return status;
        }
    }
    auto captured =
        gl::RenderToTexture2D::create(context.gl, {.width = kFaces * projector.faceSize(),
                                                   .height = projector.faceSize(),
                                                   .targets = {Format::RGBA32F},
                                                   .depth = Depth::Depth32F,
                                                   .label = "aolib/capture"});
    if (!captured) {
        return captured.status();
    }
    projector.timer.begin();
    const float farthest = farthestCorner(context.scene.bounds(), projector.position());
    const float clearance = context.scene.clearance(projector.position()).distance;
    // No geometry is nearer than the clearance, so a near plane just within it loses none; the
    // floor keeps the range of a centre on a surface finite.
    const Range range{std::max(clearance, 1e-5F * farthest) * (1.0F - kRangeSlack),
                      farthest * (1.0F + kRangeSlack)};
    projector.setDistanceCode(range.nearest, range.farthest);
    capture(context, geometry, projector, *captured, range);
    computeVisibility(context, projector, *captured, radius);
    projector.timer.end();
    projector.dirty = false;
    projector.buildMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return {};
}

void DeferredShading::capture(const BackboneContext& context, const SceneGeometry& geometry,
                              CubeMapProjector& projector, const gl::RenderToTexture2D& target,
                              const Range& range) {
    const gl::Functions& gl = context.gl;
    const std::array<GLfloat, 4> nothing{0.0F, 0.0F, 0.0F, -1.0F};
    const GLfloat deepest = 1.0F;
    target.beginAll();
    gl.ClearBufferfv(GL_COLOR, 0, nothing.data());
    gl.ClearBufferfv(GL_DEPTH, 0, &deepest);
    gl.Enable(GL_DEPTH_TEST);
    const float near = range.nearest / std::numbers::sqrt3_v<float>;
    const float far = range.farthest;
    capture_.bind();
    capture_.set("uDepthMap",
                 glm::vec2((far + near) / (far - near), -2.0F * far * near / (far - near)));
    for (int face = 0; face < kFaces; ++face) {
        gl.Viewport(face * projector.faceSize(), 0, projector.faceSize(), projector.faceSize());
        captureFace(context, geometry, projector, face);
    }
    gl.Disable(GL_DEPTH_TEST);
}

void DeferredShading::captureFace(const BackboneContext& context, const SceneGeometry& geometry,
                                  CubeMapProjector& projector, int face) {
    bool& modelled = projector.modelled[static_cast<std::size_t>(face)];
    modelled = false;
    capture_.set("uCubeToFace", cubeToFace(face));
    for (const auto& [id, mesh] : context.scene.meshes()) {
        if (!reachesFace(mesh.worldBounds(), projector.position(), face)) {
            continue;
        }
        const gl::VertexArray& triangles = geometry.mesh(id);
        capture_.set("uModelToCube", modelToCube(mesh.transform, projector.position()));
        capture_.set("uNormalMatrix", normalMatrix(mesh.transform));
        capture_.set("uHasNormals", triangles.hasNormals() ? 1 : 0);
        triangles.drawTriangles();
        modelled = true;
    }
}

void DeferredShading::computeVisibility(const BackboneContext& context,
                                        const CubeMapProjector& projector,
                                        const gl::RenderToTexture2D& captured, float radius) {
    const gl::Functions& gl = context.gl;
    const std::array<GLfloat, 4> open{1.0F, 0.0F, 0.0F, 0.0F};
    const std::array<GLfloat, 4> nothing{0.0F, 0.0F, 0.0F, 0.0F};
    projector.begin();
    gl.ClearBufferfv(GL_COLOR, 0, open.data());
    gl.ClearBufferfv(GL_COLOR, 1, nothing.data());
    visibility_.bind();
    captured.bindTexture(0, 0);
    visibility_.set("uGeometry", 0);
    visibility_.set("uFaceSize", projector.faceSize());
    visibility_.set("uDistanceCode", projector.distanceCode());
    setEstimatorUniforms(visibility_, context.options, radius);
    for (int face = 0; face < kFaces; ++face) {
        if (projector.modelled[static_cast<std::size_t>(face)]) {
            projector.beginFace(gl, face);
            visibility_.set("uFace", face);
            context.generated.drawFullscreen();
        }
    }
}

} // namespace aolib
