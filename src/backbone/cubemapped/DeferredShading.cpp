#include "backbone/cubemapped/DeferredShading.h"

#include <array>
#include <chrono>
#include <string>

#include "backbone/Estimators.h"
#include "backbone/ShaderLibrary.h"
#include "gl/Label.h"

namespace aolib {

namespace {

using Format = gl::RenderToTexture2D::Format;
using Depth = gl::RenderToTexture2D::Depth;

} // namespace

Result<DeferredShading> DeferredShading::create(const BackboneContext& context) {
    auto capture = buildShader(context.gl, "cubemap/capture.vert", "cubemap/capture.frag");
    if (!capture) {
        return capture.status();
    }
    auto peeling = LayerPeeling::create(context);
    if (!peeling) {
        return peeling.status();
    }
    auto smooth = buildShader(context.gl, "fullscreen.vert", "cubemap/smooth_texels.frag");
    if (!smooth) {
        return smooth.status();
    }
    DeferredShading shading;
    shading.capture_ = std::move(*capture);
    shading.smooth_ = std::move(*smooth);
    shading.peeling_ = std::move(*peeling);
    if (Status status = shading.chooseEstimator(context); !status) {
        return status;
    }
    return shading;
}

Status DeferredShading::chooseEstimator(const BackboneContext& context) {
    const Estimator estimator = context.options.estimator;
    auto shader =
        buildShader(context.gl, "fullscreen.vert",
                    "cubemap/visibility_" + std::string(traitsOf(estimator).shader) + ".frag");
    if (shader) {
        visibility_ = std::move(*shader);
        estimator_ = estimator;
    }
    return shader.status();
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
    projector.timer.begin();
    const DistanceRange range = distanceRange(context.scene, projector.position());
    const bool layered = traitsOf(estimator_).layered;
    const Status status = layered ? shadeLayers(context, geometry, radius, range, projector)
                                  : shadeNearest(context, geometry, radius, range, projector);
    projector.timer.end();
    if (!status) {
        return status;
    }
    projector.dirty = false;
    projector.buildMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return {};
}

Status DeferredShading::shadeNearest(const BackboneContext& context, const SceneGeometry& geometry,
                                     float radius, const DistanceRange& range,
                                     CubeMapProjector& projector) {
    const gl::Functions& gl = context.gl;
    auto captured = gl::RenderToTexture2D::create(gl, {.width = kFaces * projector.faceSize(),
                                                       .height = projector.faceSize(),
                                                       .targets = {Format::RGBA32F},
                                                       .depth = Depth::Depth32F,
                                                       .label = "aolib/capture"});
    if (!captured) {
        return captured.status();
    }
    const std::array<GLfloat, 4> nothing{0.0F, 0.0F, 0.0F, -1.0F};
    const GLfloat deepest = 1.0F;
    captured->beginAll();
    gl.ClearBufferfv(GL_COLOR, 0, nothing.data());
    gl.ClearBufferfv(GL_DEPTH, 0, &deepest);
    capture_.bind();
    projector.modelled = FaceCapture(context, geometry, projector, range).draw(capture_);
    projector.setDistanceCode(range.nearest, range.farthest);
    projector.captureBytes = captured->bytes();
    projector.layers = 1;
    visibility_.bind();
    captured->bindTexture(0, 0);
    visibility_.set("uGeometry", 0);
    visibility_.set("uFaceSize", projector.faceSize());
    setEstimatorUniforms(visibility_, context.options, radius);
    shadeFaces(context, visibility_, projector, projector.texels());
    return {};
}

Status DeferredShading::shadeLayers(const BackboneContext& context, const SceneGeometry& geometry,
                                    float radius, const DistanceRange& range,
                                    CubeMapProjector& projector) {
    const auto raw =
        CubeMapProjector::createTexels(context.gl, projector.faceSize(), "aolib/layers/raw");
    if (!raw) {
        return raw.status();
    }
    const auto layers = peeling_.capture(context, geometry, projector, range,
                                         context.options.layeredIntervals.layers);
    if (!layers) {
        return layers.status();
    }
    projector.modelled = layers->modelled;
    projector.setDistanceCode(range.nearest, range.farthest);
    projector.captureBytes = layers->bytes + raw->bytes();
    projector.layers = layers->intervals.layers();
    visibility_.bind();
    LayerPeeling::bind(visibility_, *layers, projector.faceSize());
    setEstimatorUniforms(visibility_, context.options, radius);
    shadeFaces(context, visibility_, projector, *raw);
    smooth_.bind();
    LayerPeeling::bind(smooth_, *layers, projector.faceSize());
    raw->bindTexture(0, 1);
    smooth_.set("uRaw", 1);
    shadeFaces(context, smooth_, projector, projector.texels());
    return {};
}

void DeferredShading::shadeFaces(const BackboneContext& context, gl::GLSLShader& shader,
                                 const CubeMapProjector& projector,
                                 const gl::RenderToTexture2D& texels) {
    const gl::DebugGroup group(context.gl, "aolib: texels of a cube map");
    const gl::Functions& gl = context.gl;
    const std::array<GLfloat, 4> open{1.0F, 0.0F, 0.0F, 0.0F};
    const std::array<GLfloat, 4> nothing{0.0F, 0.0F, 0.0F, 0.0F};
    texels.beginAll();
    gl.ClearBufferfv(GL_COLOR, 0, open.data());
    gl.ClearBufferfv(GL_COLOR, 1, nothing.data());
    shader.set("uDistanceCode", projector.distanceCode());
    const int size = projector.faceSize();
    for (int face = 0; face < kFaces; ++face) {
        if (projector.modelled[static_cast<std::size_t>(face)]) {
            gl.Viewport(face * size, 0, size, size);
            shader.set("uFace", face);
            context.generated.drawFullscreen();
        }
    }
}

} // namespace aolib
