#include <aolib/AmbientOcclusion.h>

#include <array>
#include <optional>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "CheckOptions.h"
#include "backbone/MakeBackbone.h"
#include "gl/StateGuard.h"
#include "scene/SceneBuilder.h"

namespace aolib {

namespace {

// Compatibility-profile names, which the core header does not declare.
constexpr GLenum kModelViewMatrix = 0x0BA6;
constexpr GLenum kProjectionMatrix = 0x0BA7;
/// How far, relative to its distance from the origin, a camera read from GL may be from the
/// position that aoDrawEnd() is given.
constexpr double kSamePosition = 1e-3;

struct Matrices {
    glm::mat4 view;
    glm::mat4 projection;
};

Matrices readMatrices(const gl::Functions& gl) {
    Matrices read{};
    gl.GetFloatv(kModelViewMatrix, glm::value_ptr(read.view));
    gl.GetFloatv(kProjectionMatrix, glm::value_ptr(read.projection));
    return read;
}

/// Set while it lives.
class Flag {
public:
    explicit Flag(bool& value) : value_(value) { value_ = true; }
    ~Flag() { value_ = false; }
    Flag(const Flag&) = delete;
    Flag& operator=(const Flag&) = delete;

private:
    bool& value_;
};

Status checkBox(const Bounds& box) {
    if (!isFinite(box.min) || !isFinite(box.max) || box.empty()) {
        return {StatusCode::InvalidPosition,
                "the corners of the box must be finite, and the first nowhere above the second"};
    }
    return {};
}

bool standsAt(const HostCamera& camera, const glm::vec3& position) {
    const double scale = 1.0 + glm::length(glm::dvec3(position));
    return glm::distance(camera.eye(), glm::dvec3(position)) <= kSamePosition * scale;
}

} // namespace

struct AmbientOcclusion::Impl {
    gl::Functions gl;
    Options options;
    Scene scene;
    SceneBuilder builder;
    gl::VertexArray generated;
    std::unique_ptr<AbstractTexelTracer> tracer;
    SceneRenderer renderer; ///< calls the host's, and has other calls refused meanwhile
    bool rendering = false; ///< the host's renderer runs
    std::unique_ptr<AbstractBackbone> backbone;
    std::optional<HostCamera> camera; ///< as aoSetCamera() gave it
    std::optional<Matrices> atBegin;  ///< GL's matrices at aoDrawBegin()
    bool drawing = false;
    Status lastStatus;
    MessageSink sink;

    BackboneContext context() { return {gl, generated, scene, options, tracer, renderer}; }

    Status report(Status status) {
        if (!status) {
            lastStatus = status;
            if (sink) {
                sink(status);
            }
        }
        return status;
    }
    template <typename T>
    Result<T> report(Result<T> result) {
        report(result.status());
        return result;
    }

    /// Ok, but within the host's scene renderer.
    Status allowed() const {
        return rendering ? Status(StatusCode::InvalidCallOrder,
                                  "not allowed within the scene renderer of the same instance")
                         : Status();
    }
    /// A call to the backbone on a clean slate. Reports come after it: a message sink is the host's
    /// code and finds the host's state.
    template <typename Call>
    auto guarded(Call call) -> decltype(call(*backbone)) {
        if (Status status = allowed(); !status) {
            return status;
        }
        const gl::StateGuard guard(gl);
        return call(*backbone);
    }

    Result<HostCamera> cameraAt(const glm::vec3& position) const;
    /// A frame seen from `position`, but for what it is drawn to.
    Result<Frame> frameAt(const glm::vec3& position) const;
    Status drawEnd(const glm::vec3& position);
};

AmbientOcclusion::AmbientOcclusion(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
AmbientOcclusion::AmbientOcclusion(AmbientOcclusion&&) noexcept = default;
AmbientOcclusion& AmbientOcclusion::operator=(AmbientOcclusion&&) noexcept = default;
AmbientOcclusion::~AmbientOcclusion() = default;

Result<AmbientOcclusion> AmbientOcclusion::create(const ProcAddressLoader& loader,
                                                  const Options& options) {
    if (Status status = checkOptions(options); !status) {
        return status;
    }
    auto functions = gl::Functions::load(loader);
    if (!functions) {
        return functions.status();
    }
    auto impl = std::make_unique<Impl>();
    impl->gl = *functions;
    impl->options = options;
    const gl::StateGuard guard(impl->gl);
    auto generated = gl::VertexArray::createEmpty(impl->gl, "aolib/generated");
    if (!generated) {
        return generated.status();
    }
    impl->generated = std::move(*generated);
    auto backbone = makeBackbone(impl->context());
    if (!backbone) {
        return backbone.status();
    }
    impl->backbone = std::move(*backbone);
    return AmbientOcclusion(std::move(impl));
}

// ---- Options ------------------------------------------------------------------------------------

const Options& AmbientOcclusion::options() const {
    return impl_->options;
}

Status AmbientOcclusion::setOptions(const Options& options) {
    Status status = impl_->allowed();
    if (status) {
        status = checkOptions(options);
    }
    if (!status) {
        return impl_->report(std::move(status));
    }
    const Options before = std::exchange(impl_->options, options);
    if (before.backbone == options.backbone) {
        impl_->backbone->optionsChanged(before);
        return {};
    }
    status = impl_->guarded([&](AbstractBackbone& /*old*/) {
        auto backbone = makeBackbone(impl_->context());
        if (backbone) {
            impl_->backbone = std::move(*backbone);
        }
        return backbone.status();
    });
    if (!status) {
        impl_->options = before;
    }
    return impl_->report(std::move(status));
}

void AmbientOcclusion::setTexelTracer(std::unique_ptr<AbstractTexelTracer> tracer) {
    if (!impl_->report(impl_->allowed())) {
        return;
    }
    impl_->backbone->dropTracer();
    impl_->tracer = std::move(tracer);
}

// ---- Scene definition ---------------------------------------------------------------------------

Status AmbientOcclusion::meshBegin() {
    return impl_->report(impl_->builder.begin());
}
Status AmbientOcclusion::aoNormal3f(float x, float y, float z) {
    return impl_->report(impl_->builder.normal({x, y, z}));
}
Status AmbientOcclusion::aoVertex3f(float x, float y, float z) {
    return impl_->report(impl_->builder.vertex({x, y, z}));
}
Status AmbientOcclusion::aoBegin(AoPrimitive primitive) {
    return impl_->report(impl_->builder.beginRun(primitive));
}
Status AmbientOcclusion::aoVertexIndex(std::uint32_t index) {
    return impl_->report(impl_->builder.index(index));
}
Status AmbientOcclusion::aoEnd() {
    return impl_->report(impl_->builder.endRun());
}

Result<MeshId> AmbientOcclusion::meshEnd() {
    Result<Mesh> mesh = impl_->builder.end();
    if (!mesh) {
        return impl_->report(mesh.status());
    }
    return impl_->scene.add(std::move(*mesh));
}

Result<MeshId> AmbientOcclusion::addMesh(const MeshData& data) {
    Result<Mesh> mesh = makeMesh(data);
    if (!mesh) {
        return impl_->report(mesh.status());
    }
    return impl_->scene.add(std::move(*mesh));
}

Status AmbientOcclusion::replaceMesh(MeshId id, const MeshData& data) {
    Result<Mesh> mesh = makeMesh(data);
    if (!mesh) {
        return impl_->report(mesh.status());
    }
    return impl_->report(impl_->scene.replace(id, std::move(*mesh)));
}

Status AmbientOcclusion::moveMesh(MeshId id, const glm::mat4& transform) {
    return impl_->report(impl_->scene.move(id, transform));
}

Status AmbientOcclusion::removeMesh(MeshId id) {
    return impl_->report(impl_->scene.remove(id));
}

Status AmbientOcclusion::setSceneRenderer(SceneRenderer renderer, const glm::vec3& min,
                                          const glm::vec3& max) {
    if (Status status = impl_->allowed(); !status) {
        return impl_->report(std::move(status));
    }
    if (!renderer) {
        impl_->renderer = nullptr;
        impl_->scene.setDrawn({});
        impl_->backbone->rendererChanged();
        return {};
    }
    const Bounds box{min, max};
    if (Status status = checkBox(box); !status) {
        return impl_->report(std::move(status));
    }
    impl_->renderer = [impl = impl_.get(), host = std::move(renderer)](const FaceView& view) {
        const Flag running(impl->rendering);
        host(view);
    };
    impl_->scene.setDrawn(box);
    impl_->backbone->rendererChanged();
    return {};
}

Status AmbientOcclusion::aoSceneChanged(const glm::vec3& min, const glm::vec3& max) {
    const Bounds box{min, max};
    Status status = checkBox(box);
    if (status && !impl_->scene.drawn()) {
        status = {StatusCode::NoScene, "aoSceneChanged: there is no scene renderer"};
    }
    if (status) {
        impl_->scene.touch(box);
    }
    return impl_->report(std::move(status));
}

// ---- Cube maps ----------------------------------------------------------------------------------

Result<CubeMapId> AmbientOcclusion::addCubeMap(const glm::vec3& position) {
    if (!isFinite(position)) {
        return impl_->report(
            Status(StatusCode::InvalidPosition, "the position of a cube map must be finite"));
    }
    return impl_->report(
        impl_->guarded([&](AbstractBackbone& to) { return to.addCubeMap(position); }));
}

Status AmbientOcclusion::removeCubeMap(CubeMapId id) {
    return impl_->report(
        impl_->guarded([&](AbstractBackbone& to) { return to.removeCubeMap(id); }));
}

Status AmbientOcclusion::clear() {
    return impl_->report(impl_->guarded([&](AbstractBackbone& to) { return to.clear(); }));
}

std::vector<CubeMapInfo> AmbientOcclusion::cubeMaps() const {
    return impl_->backbone->cubeMaps();
}

// ---- Frame --------------------------------------------------------------------------------------

Status AmbientOcclusion::aoSetCamera(const glm::mat4& view, const glm::mat4& projection) {
    Result<HostCamera> camera = HostCamera::create(view, projection);
    if (camera) {
        impl_->camera = *camera;
    }
    return impl_->report(camera.status());
}

Status AmbientOcclusion::aoDrawBegin() {
    if (Status status = impl_->allowed(); !status) {
        return impl_->report(std::move(status));
    }
    if (impl_->drawing) {
        return impl_->report({StatusCode::InvalidCallOrder,
                              "aoDrawBegin: a frame was begun already; end it with aoDrawEnd"});
    }
    impl_->drawing = true;
    impl_->atBegin.reset();
    if (!impl_->camera && impl_->gl.capabilities.compatibility) {
        impl_->atBegin = readMatrices(impl_->gl);
    }
    return {};
}

Status AmbientOcclusion::aoDrawEnd(float x, float y, float z) {
    if (Status status = impl_->allowed(); !status) {
        return impl_->report(std::move(status));
    }
    if (!impl_->drawing) {
        return impl_->report({StatusCode::InvalidCallOrder,
                              "aoDrawEnd: no frame was begun; call aoDrawBegin before drawing"});
    }
    impl_->drawing = false;
    return impl_->report(impl_->drawEnd({x, y, z}));
}

Result<HostCamera> AmbientOcclusion::Impl::cameraAt(const glm::vec3& position) const {
    if (camera) {
        return *camera;
    }
    if (!gl.capabilities.compatibility) {
        return Status(StatusCode::NoCamera,
                      "a core profile has no matrices to read: call aoSetCamera first");
    }
    // Whichever of the two moments had the camera, and no model transform, on the stack.
    const Matrices now = readMatrices(gl);
    const Result<HostCamera> atEnd = HostCamera::create(now.view, now.projection);
    if (atEnd && standsAt(*atEnd, position)) {
        return atEnd;
    }
    if (atBegin) {
        const Result<HostCamera> begun = HostCamera::create(atBegin->view, atBegin->projection);
        if (begun && standsAt(*begun, position)) {
            return begun;
        }
    }
    return Status(StatusCode::InvalidCamera,
                  "GL's modelview matrix belonged to the position given to aoDrawEnd neither at "
                  "aoDrawBegin nor now; leave the camera alone on the stack at one of them, or "
                  "call aoSetCamera");
}

Result<Frame> AmbientOcclusion::Impl::frameAt(const glm::vec3& position) const {
    if (!isFinite(position)) {
        return Status(StatusCode::InvalidCamera, "the camera's position must be finite");
    }
    const Result<HostCamera> found = cameraAt(position);
    if (!found) {
        return found.status();
    }
    ClipConvention clip;
    if (gl.capabilities.clipControl) {
        GLint value = 0;
        gl.GetIntegerv(GL_CLIP_DEPTH_MODE, &value);
        clip.zeroToOne = value == GL_ZERO_TO_ONE;
        gl.GetIntegerv(GL_CLIP_ORIGIN, &value);
        clip.upperLeft = value == GL_UPPER_LEFT;
    }
    gl.GetDoublev(GL_DEPTH_RANGE, clip.depthRange.data());
    if (clip.depthRange[0] == clip.depthRange[1]) {
        return Status(StatusCode::InvalidFramebuffer,
                      "glDepthRange is empty: depth holds no distances");
    }
    return Frame{.camera = *found, .position = position, .clip = clip};
}

Status AmbientOcclusion::Impl::drawEnd(const glm::vec3& position) {
    Result<Frame> frame = frameAt(position);
    if (!frame) {
        return frame.status();
    }
    const gl::StateGuard guard(gl);
    const std::array<GLint, 4>& viewport = guard.hostViewport();
    if (viewport[2] < 1 || viewport[3] < 1) {
        return {StatusCode::InvalidFramebuffer, "the viewport is " + std::to_string(viewport[2]) +
                                                    " x " + std::to_string(viewport[3]) +
                                                    " pixels"};
    }
    frame->framebuffer = frame->depthFramebuffer = guard.hostDrawFramebuffer();
    frame->origin = {viewport[0], viewport[1]};
    frame->size = {viewport[2], viewport[3]};
    frame->srgb = guard.hostSrgb();
    frame->scissor = guard.hostScissor();
    return backbone->drawEnd(*frame);
}

Result<TextureName> AmbientOcclusion::aoApply(const HostTextures& textures,
                                              const glm::vec3& position) {
    if (Status status = impl_->allowed(); !status) {
        return impl_->report(std::move(status));
    }
    Result<Frame> frame = impl_->frameAt(position);
    if (!frame) {
        return impl_->report(frame.status());
    }
    const auto apply = [&]() -> Result<TextureName> {
        const gl::StateGuard guard(impl_->gl);
        frame->srgb = guard.hostSrgb();
        return impl_->backbone->apply(*frame, textures);
    };
    return impl_->report(apply());
}

// ---- Results ------------------------------------------------------------------------------------

Statistics AmbientOcclusion::statistics() const {
    return impl_->backbone->statistics();
}

Result<VisibilityImage> AmbientOcclusion::readVisibility() {
    return impl_->report(impl_->guarded([&](AbstractBackbone& to) { return to.readVisibility(); }));
}

Result<CubeMapImage> AmbientOcclusion::readCubeMap(CubeMapId id) {
    return impl_->report(impl_->guarded([&](AbstractBackbone& to) { return to.readCubeMap(id); }));
}

const Status& AmbientOcclusion::lastStatus() const {
    return impl_->lastStatus;
}
void AmbientOcclusion::setMessageSink(MessageSink sink) {
    impl_->sink = std::move(sink);
}

} // namespace aolib
