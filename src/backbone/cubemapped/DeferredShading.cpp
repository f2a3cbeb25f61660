#include "backbone/cubemapped/DeferredShading.h"

#include <array>
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
    DeferredShading shading;
    shading.capture_ = std::move(*capture);
    shading.peeling_ = std::move(*peeling);
    if (Status status = shading.chooseEstimator(context); !status) {
        return status;
    }
    return shading;
}

int DeferredShading::passes(const Options& options) {
    return options.estimator == Estimator::LayeredIntervals ? options.layeredIntervals.slices : 1;
}

Status DeferredShading::chooseEstimator(const BackboneContext& context) {
    const Estimator estimator = context.options.estimator;
    if (estimator_ == estimator || estimator == Estimator::RayTraced) {
        return {};
    }
    const EstimatorTraits traits = traitsOf(estimator);
    auto visibility = buildShader(context.gl, "fullscreen.vert",
                                  "cubemap/visibility_" + std::string(traits.shader) + ".frag");
    if (!visibility) {
        return visibility.status();
    }
    auto resolve =
        buildShader(context.gl, "fullscreen.vert",
                    traits.layered ? "cubemap/smooth_texels.frag" : "cubemap/resolve_nearest.frag");
    if (!resolve) {
        return resolve.status();
    }
    visibility_ = std::move(*visibility);
    resolve_ = std::move(*resolve);
    estimator_ = estimator;
    return {};
}

// ---- Capture ------------------------------------------------------------------------------------

Result<CubeMapCapture> DeferredShading::capture(const BackboneContext& context,
                                                const SceneGeometry& geometry,
                                                CubeMapProjector& projector, FaceStore& store) {
    const gl::DebugGroup group(context.gl, "aolib: capture a cube map");
    if (context.scene.empty()) {
        return Status(StatusCode::NoScene,
                      "there are no triangles to place a cube map among; describe a mesh first");
    }
    if (Status status = chooseEstimator(context); !status) {
        return status;
    }
    CubeMapCapture capture;
    const int size = projector.tiles.faceSize();
    auto accumulated = gl::RenderToTexture2D::create(context.gl, {.width = kFaces * size,
                                                                  .height = size,
                                                                  .targets = {Format::RG32F},
                                                                  .label = "aolib/accumulated"});
    if (!accumulated) {
        return accumulated.status();
    }
    const std::array<GLfloat, 4> nothing{};
    accumulated->begin(0);
    context.gl.ClearBufferfv(GL_COLOR, 0, nothing.data());
    capture.accumulated = std::move(*accumulated);
    const DistanceRange range = distanceRange(context.scene, projector.position());
    projector.spanDistances(store, range.nearest, range.farthest);
    const Status status = traitsOf(*estimator_).layered
                              ? captureLayers(context, geometry, range, projector, store, capture)
                              : captureNearest(context, geometry, range, projector, store, capture);
    if (!status) {
        return status;
    }
    capture.bytes += capture.accumulated.bytes();
    projector.captureBytes = capture.bytes;
    return capture;
}

Status DeferredShading::captureNearest(const BackboneContext& context,
                                       const SceneGeometry& geometry, const DistanceRange& range,
                                       CubeMapProjector& projector, FaceStore& store,
                                       CubeMapCapture& capture) {
    const gl::Functions& gl = context.gl;
    const int size = projector.tiles.faceSize();
    auto nearest = gl::RenderToTexture2D::create(gl, {.width = kFaces * size,
                                                      .height = size,
                                                      .targets = {Format::RGBA32F},
                                                      .depth = Depth::Depth32F,
                                                      .label = "aolib/capture"});
    if (!nearest) {
        return nearest.status();
    }
    const std::array<GLfloat, 4> nothing{0.0F, 0.0F, 0.0F, -1.0F};
    const GLfloat deepest = 1.0F;
    nearest->beginAll();
    gl.ClearBufferfv(GL_COLOR, 0, nothing.data());
    gl.ClearBufferfv(GL_DEPTH, 0, &deepest);
    capture_.bind();
    const auto drawn = FaceCapture(context, geometry, projector, range).draw(capture_);
    projector.captured = 1;
    capture.nearest = std::move(*nearest);
    capture.bytes = capture.nearest.bytes();
    return projector.keepFaces(store, drawn);
}

Status DeferredShading::captureLayers(const BackboneContext& context, const SceneGeometry& geometry,
                                      const DistanceRange& range, CubeMapProjector& projector,
                                      FaceStore& store, CubeMapCapture& capture) {
    auto layers = peeling_.capture(context, geometry, projector, range,
                                   context.options.layeredIntervals.layers);
    if (!layers) {
        return layers.status();
    }
    projector.captured = layers->intervals.layers();
    capture.bytes = layers->bytes;
    capture.layers = std::move(*layers);
    return projector.keepFaces(store, capture.layers->modelled);
}

// ---- Texels -------------------------------------------------------------------------------------

void DeferredShading::bind(gl::GLSLShader& shader, const CubeMapCapture& capture, int faceSize) {
    shader.bind();
    if (capture.layers) {
        LayerPeeling::bind(shader, *capture.layers, faceSize);
    } else {
        capture.nearest.bindTexture(0, 0);
        shader.set("uGeometry", 0);
        shader.set("uFaceSize", faceSize);
    }
}

void DeferredShading::accumulate(const BackboneContext& context, const CubeMapCapture& capture,
                                 float radius, const TileProgress::Region& region, int first,
                                 int count) {
    const gl::DebugGroup group(context.gl, "aolib: texels of a cube map");
    const gl::Functions& gl = context.gl;
    const int size = capture.accumulated.height();
    capture.accumulated.begin(0);
    gl.Viewport(region.face * size + region.x, region.y, region.width, region.height);
    bind(visibility_, capture, size);
    visibility_.set("uFace", region.face);
    visibility_.set("uFirstSlice", first);
    visibility_.set("uSliceCount", count);
    setEstimatorUniforms(visibility_, context.options, radius);
    gl.Enable(GL_BLEND);
    gl.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    context.generated.drawFullscreen();
    gl.Disable(GL_BLEND);
}

void DeferredShading::resolve(const BackboneContext& context, const CubeMapCapture& capture,
                              const CubeMapProjector& projector, const FaceStore& store,
                              const TileProgress::Region& region) {
    const gl::DebugGroup group(context.gl, "aolib: keep texels");
    store.begin(projector.layer(region.face));
    context.gl.Viewport(region.x, region.y, region.width, region.height);
    bind(resolve_, capture, store.faceSize());
    capture.accumulated.bindTexture(0, 1);
    resolve_.set("uAccumulated", 1);
    resolve_.set("uFace", region.face);
    resolve_.set("uDepthCode", projector.depthCode());
    context.generated.drawFullscreen();
}

} // namespace aolib
