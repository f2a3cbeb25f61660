#include "backbone/texels/DrawnCapture.h"

#include <exception>
#include <string>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/trigonometric.hpp>

#include "backbone/estimators/Estimators.h"
#include "backbone/frame/ShaderLibrary.h"
#include "gl/Label.h"
#include "gl/StateGuard.h"
#include "shared/cube_faces.h"

namespace aolib {

namespace {

using Format = gl::RenderToTexture2D::Format;

/// Nearest distance of a capture as a share of the farthest: how near geometry is, is unknown.
constexpr float kNearest = 1e-3F;
/// Step of a depth buffer of 32-bit floating point near its far end.
constexpr double kDepthQuantum = 1.0 / 16777216.0;

FaceView viewOf(const glm::vec3& centre, int face, int size, const DistanceRange& range) {
    const glm::vec3 right = shared::faceRight(face);
    const glm::vec3 up = shared::faceUp(face);
    const glm::vec3 back = -shared::faceForward(face);
    const glm::mat3 rotation = glm::transpose(glm::mat3(right, up, back));
    FaceView view{glm::mat4(rotation), glm::mat4(1.0F), centre, glm::ivec2(size)};
    view.view[3] = glm::vec4(rotation * -centre, 1.0F);
    view.projection =
        glm::perspectiveRH_NO(glm::radians(90.0F), 1.0F, range.nearest, range.farthest);
    return view;
}

} // namespace

AoStatus DrawnCapture::Shaders::build(const BackboneContext& context, bool asIntervals) {
    std::optional<gl::GLSLShader>& wanted = asIntervals ? intervals : nearest;
    if (wanted) {
        return {};
    }
    auto built = buildShader(context.gl, "fullscreen.vert", "cubemap/drawn_face.frag",
                             {asIntervals ? "AO_INTERVALS" : ""});
    if (built) {
        wanted = std::move(*built);
    }
    return built.status();
}

DistanceRange DrawnCapture::distanceRange(const Scene& scene, const glm::vec3& centre) {
    const Bounds& box = scene.bounds();
    const float farthest =
        glm::length(glm::max(glm::abs(box.min - centre), glm::abs(box.max - centre)));
    return {kNearest * farthest, farthest};
}

std::size_t DrawnCapture::bytes() const {
    return (depth_ ? depth_.bytes() : 0) + (nearest_ ? nearest_.bytes() : 0) + intervals_.bytes();
}

AoStatus DrawnCapture::makeTargets() {
    AoStatus status;
    if (asIntervals_) {
        auto made = gl::TextureStack::create(context_.gl, {.width = size_,
                                                           .height = size_,
                                                           .layers = kFaces,
                                                           .format = Format::RGBA32F,
                                                           .label = "aolib/layers"});
        status = made.status();
        if (made) {
            intervals_ = std::move(*made);
        }
    } else {
        auto made = gl::RenderToTexture2D::create(context_.gl, {.width = kFaces * size_,
                                                                .height = size_,
                                                                .targets = {Format::RGBA32F},
                                                                .label = "aolib/capture"});
        status = made.status();
        if (made) {
            nearest_ = std::move(*made);
            const std::array<GLfloat, 4> nothing{0.0F, 0.0F, 0.0F, -1.0F};
            nearest_.bindAllAsTargets();
            context_.gl.ClearBufferfv(GL_COLOR, 0, nothing.data());
        }
    }
    if (!status) {
        return status;
    }
    auto depth =
        gl::RenderToTexture2D::create(context_.gl, {.width = size_,
                                                    .height = size_,
                                                    .targets = {},
                                                    .depth = gl::RenderToTexture2D::Depth::Depth32F,
                                                    .label = "aolib/drawn"});
    if (depth) {
        depth_ = std::move(*depth);
        mostBytes_ = bytes();
    }
    return depth.status();
}

AoStatus DrawnCapture::drawFace(const FaceView& view) const {
    const gl::Functions& gl = context_.gl;
    // The callback may leave any state: what it finds, a known GL state, is put back after it.
    const gl::StateGuard guard(gl);
    const GLfloat deepest = 1.0F;
    depth_.bindAllAsTargets();
    gl.ClearBufferfv(GL_DEPTH, 0, &deepest);
    gl.Enable(GL_DEPTH_TEST);
    try {
        context_.renderer(view);
    } catch (const std::exception& thrown) {
        return {StatusCode::CallbackFailed,
                std::string("the scene renderer threw: ") + thrown.what()};
    } catch (...) {
        return {StatusCode::CallbackFailed,
                "the scene renderer threw an exception that is not a std::exception"};
    }
    return {};
}

AoStatus DrawnCapture::convertFace(const FaceView& view) {
    const auto camera = HostCamera::create(view.view, view.projection);
    if (!camera) {
        return camera.status();
    }
    const glm::ivec2 origin(asIntervals_ ? 0 : face_ * size_, 0);
    if (asIntervals_) {
        intervals_.bindAsTarget(face_);
    } else {
        nearest_.bindAllAsTargets();
    }
    gl::setViewport(context_.gl, origin.x, origin.y, size_, size_);
    shader_.bind();
    depth_.bindDepthTexture(0);
    shader_.set("uDepth", 0);
    shader_.set("uOrigin", origin);
    if (asIntervals_) {
        shader_.set("uThickness", assumedThickness(context_.options));
    }
    camera->setUniforms(shader_, view.size, {.depthQuantum = kDepthQuantum});
    context_.emptyVertexArray.drawFullscreen();
    return {};
}

AoStatus DrawnCapture::step() {
    const gl::DebugGroup group(context_.gl, "aolib: a face that the host draws");
    if (!depth_) {
        return makeTargets();
    }
    if (reachesFace(context_.scene.bounds(), centre_, face_)) {
        const FaceView view = viewOf(centre_, face_, size_, range_);
        AoStatus status = drawFace(view);
        if (status) {
            status = convertFace(view);
        }
        if (!status) {
            return status;
        }
        modelled_[static_cast<std::size_t>(face_)] = true;
    }
    if (++face_ == kFaces) {
        depth_ = {};
    }
    return {};
}

void DrawnCapture::bind(gl::GLSLShader& shader) const {
    if (asIntervals_) {
        std::array<glm::ivec4, kFaces> faceLayers{};
        for (int face = 0; face < kFaces; ++face) {
            const auto i = static_cast<std::size_t>(face);
            faceLayers[i] = {face, modelled_[i] ? 1 : 0, 0, 0};
        }
        intervals_.bind(0);
        shader.set("uIntervals", 0);
        shader.set("uFaceLayers", faceLayers);
        shader.set("uLayers", 1);
    } else {
        nearest_.bindTexture(0, 0);
        shader.set("uGeometry", 0);
    }
    shader.set("uFaceSize", size_);
}

} // namespace aolib
