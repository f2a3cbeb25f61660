#include "backbone/texels/DeferredShading.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "backbone/estimators/Estimators.h"
#include "backbone/frame/ShaderLibrary.h"
#include "backbone/texels/LayerCapture.h"
#include "backbone/texels/NearestCapture.h"
#include "gl/Label.h"
#include "gl/StateGuard.h"

namespace aolib {

namespace {

/// How texels take noise out of each other (shaders/cubemap/smooth_texels.frag): less of it leaves
/// noise, more takes away what is true within a texel's distance (docs/accuracy.md).
struct Smoothing {
    int reach;       ///< texels to each side
    float ownWeight; ///< of a texel beside each of the others
};
constexpr Smoothing kSmoothing{1, 4.0F};
/// Of texels that have had less than this share of their passes, in which noise is most of the
/// error.
constexpr float kFewPasses = 0.4F;
constexpr Smoothing kSmoothingOfFew{2, 1.0F};

/// Texels about a tile that the smoothing of its border looks at.
constexpr int kApron = kSmoothing.reach;

/// Where a face's first texel would lie in what accumulates the surfaces behind one of its tiles.
glm::ivec2 hiddenOrigin(const TileTable::Region& region) {
    return kApron - glm::ivec2(region.x, region.y);
}

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
    if (AoStatus status = shading.chooseEstimator(context); !status) {
        return status;
    }
    return shading;
}

AoStatus DeferredShading::chooseEstimator(const BackboneContext& context) {
    const EstimatorTraits& traits = traitsOf(context.options.estimator);
    if (estimator_ == traits.estimator || traits.needsTracer) {
        return {};
    }
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
    estimator_ = traits.estimator;
    return {};
}

// ---- Capture ------------------------------------------------------------------------------------

Result<DeferredShading::Surroundings>
DeferredShading::surroundings(const BackboneContext& context, const SceneGeometry& geometry,
                              const glm::dvec3& centre, int faceSize,
                              const std::optional<ViewFace>& view) {
    if (context.scene.empty()) {
        return AoStatus(StatusCode::NoScene,
                        "there are no triangles to place a cube map among; describe a mesh first");
    }
    if (AoStatus status = chooseEstimator(context); !status) {
        return status;
    }
    const bool layered = traitsOf(*estimator_).layered;
    const glm::vec3 position(centre);
    if (context.renderer) {
        if (AoStatus status = drawn_.build(context, layered); !status) {
            return status;
        }
        const DistanceRange range = DrawnCapture::distanceRange(context.scene, position);
        return Surroundings{
            std::make_unique<DrawnCapture>(context, position, faceSize, range, drawn_, layered),
            range};
    }
    const DistanceRange range = distanceRange(context.scene, position);
    const FaceCapture faces(context, geometry.instances(context.scene), centre, faceSize, range,
                            view);
    if (layered) {
        return Surroundings{std::make_unique<LayerCapture>(
                                context, faces, geometry.enclosingSolids(context.scene, position),
                                peeling_, context.options.layeredIntervals.layers),
                            range};
    }
    return Surroundings{std::make_unique<NearestCapture>(context, faces, capture_), range};
}

Result<CubeMapCapture> DeferredShading::begin(const BackboneContext& context,
                                              const SceneGeometry& geometry,
                                              CubeMapProjector& projector) {
    auto around =
        surroundings(context, geometry, projector.position(), projector.tiles().faceSize());
    if (!around) {
        return around.status();
    }
    projector.spanDistances(around->range.nearest, around->range.farthest);
    CubeMapCapture capture;
    capture.geometry = std::move(around->capture);
    return capture;
}

AoStatus DeferredShading::step(const BackboneContext& context, CubeMapCapture& capture,
                               CubeMapProjector& projector) {
    if (!capture.geometry->complete()) {
        return capture.geometry->step();
    }
    if (capture.accumulated) {
        projector.recordCapture(capture.geometry->layers(),
                                std::max(capture.geometry->mostBytes(), capture.bytes()));
        const AoStatus status = projector.allocateFaces(capture.geometry->modelled());
        capture.ready = status.ok();
        return status;
    }
    const int size = projector.tiles().faceSize();
    auto accumulated = gl::RenderToTexture2D::create(
        context.gl, {.width = kFaces * size,
                     .height = size,
                     .targets = {gl::RenderToTexture2D::Format::RG32F},
                     .label = "aolib/accumulated"});
    if (accumulated) {
        const std::array<GLfloat, 4> nothing{};
        accumulated->bindAsTarget(0);
        context.gl.ClearBufferfv(GL_COLOR, 0, nothing.data());
        capture.accumulated = std::move(*accumulated);
    }
    return accumulated.status();
}

// ---- Texels -------------------------------------------------------------------------------------

void DeferredShading::addPasses(const BackboneContext& context, const CubeMapCapture& capture,
                                const Receivers& receivers, int first, int count) {
    const gl::DebugGroup group(context.gl, "aolib: texels of a cube map");
    visibility_.bind();
    capture.geometry->bind(visibility_);
    visibility_.set("uFace", receivers.face);
    visibility_.set("uLayer", receivers.layer);
    visibility_.set("uFaceOrigin", receivers.origin);
    visibility_.set("uFirstSlice", first);
    visibility_.set("uSliceCount", count);
    setEstimatorUniforms(visibility_, context.options);
    gl::beginBlending(context.gl, GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    context.emptyVertexArray.drawFullscreen();
    gl::endBlending(context.gl);
}

void DeferredShading::keep(const BackboneContext& context, const CubeMapCapture& capture,
                           const CubeMapProjector& projector, const Receivers& receivers,
                           const gl::RenderToTexture2D& accumulated, const glm::ivec2& keptOrigin,
                           float share) {
    const gl::DebugGroup group(context.gl, "aolib: keep texels");
    const Smoothing& smoothing = share < kFewPasses ? kSmoothingOfFew : kSmoothing;
    resolve_.bind();
    capture.geometry->bind(resolve_);
    accumulated.bindTexture(0, 1);
    resolve_.set("uAccumulated", 1);
    resolve_.set("uFace", receivers.face);
    resolve_.set("uLayer", receivers.layer);
    resolve_.set("uFaceOrigin", receivers.origin);
    resolve_.set("uKeptOrigin", keptOrigin);
    resolve_.set("uDepthCode", projector.depthCode());
    resolve_.set("uReach", smoothing.reach);
    resolve_.set("uOwnWeight", smoothing.ownWeight);
    context.emptyVertexArray.drawFullscreen();
}

void DeferredShading::accumulate(const BackboneContext& context, const CubeMapCapture& capture,
                                 const TileTable::Region& region, int first, int count) {
    const glm::ivec2 origin(region.face * capture.accumulated.height(), 0);
    capture.accumulated.bindAsTarget(0);
    gl::setViewport(context.gl, origin.x + region.x, region.y, region.width, region.height);
    addPasses(context, capture, {region.face, 0, origin}, first, count);
}

void DeferredShading::resolve(const BackboneContext& context, const CubeMapCapture& capture,
                              const CubeMapProjector& projector, const FaceStore& store,
                              const TileTable::Region& region, float share) {
    const glm::ivec2 origin(region.face * capture.accumulated.height(), 0);
    store.bindAsTarget(projector.layer(region.face));
    gl::setViewport(context.gl, region.x, region.y, region.width, region.height);
    keep(context, capture, projector, {region.face, 0, origin}, capture.accumulated, {}, share);
}

AoStatus DeferredShading::accumulateHidden(const BackboneContext& context, CubeMapCapture& capture,
                                           const TileTable::Region& region, int layer, int pass) {
    constexpr int kEdge = TileTable::kTile + 2 * kApron;
    if (AoStatus status =
            capture.hidden.reset(context.gl, {.width = kEdge,
                                              .height = kEdge,
                                              .targets = {gl::RenderToTexture2D::Format::RG32F},
                                              .label = "aolib/accumulated/hidden"});
        !status) {
        return status;
    }
    capture.hidden.bindAsTarget(0);
    if (pass == 0) {
        const std::array<GLfloat, 4> nothing{};
        context.gl.ClearBufferfv(GL_COLOR, 0, nothing.data());
    }
    addPasses(context, capture, {region.face, layer, hiddenOrigin(region)}, pass, 1);
    return {};
}

void DeferredShading::resolveHidden(const BackboneContext& context, const CubeMapCapture& capture,
                                    const CubeMapProjector& projector, const PageStore& pages,
                                    int page, const TileTable::Region& region, int layer) {
    const glm::ivec2 at = pages.bindAsTarget(page);
    gl::setViewport(context.gl, at.x, at.y, region.width, region.height);
    keep(context, capture, projector, {region.face, layer, hiddenOrigin(region)}, capture.hidden,
         at - glm::ivec2(region.x, region.y), 1.0F);
}

} // namespace aolib
