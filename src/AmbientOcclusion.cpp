#include <aolib/AmbientOcclusion.h>

#include <utility>

#include "AmbientOcclusionImpl.h"
#include "CheckOptions.h"
#include "FormerNames.h"
#include "backbone/MakeBackbone.h"

namespace aolib {

namespace {

AoStatus checkBox(const Bounds& box) {
    if (!isFinite(box.min) || !isFinite(box.max) || box.empty()) {
        return {StatusCode::InvalidPosition,
                "box: min and max must be finite, and min must not exceed max in any component"};
    }
    return {};
}

} // namespace

AmbientOcclusion::AmbientOcclusion(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
AmbientOcclusion::AmbientOcclusion(AmbientOcclusion&&) noexcept = default;
AmbientOcclusion& AmbientOcclusion::operator=(AmbientOcclusion&&) noexcept = default;
AmbientOcclusion::~AmbientOcclusion() = default;

Result<AmbientOcclusion> AmbientOcclusion::create(const ProcAddressLoader& loader,
                                                  const Options& options) {
    if (AoStatus status = checkOptions(options); !status) {
        return status;
    }
    auto functions = gl::Functions::load(loader);
    if (!functions) {
        return functions.status();
    }
    auto impl = std::make_unique<Impl>(*functions);
    impl->options = options;
    impl->resolveOptions();
    AoStatus status = impl->contexts.found();
    if (status) {
        status = impl->onKnownState([&](const gl::StateGuard& /*guard*/) { return impl->build(); });
    }
    if (!status) {
        return status;
    }
    return AmbientOcclusion(std::move(impl));
}

AoStatus AmbientOcclusion::Impl::build() {
    if (!emptyVertexArray) {
        auto made = gl::VertexArray::createEmpty(gl, "aolib/generated");
        if (!made) {
            return made.status();
        }
        emptyVertexArray = std::move(*made);
    }
    auto made = makeBackbone(context());
    if (made) {
        backbone = std::move(*made);
    }
    return made.status();
}

void AmbientOcclusion::abandon() {
    if (impl_->report(impl_->checkNotInCallback())) {
        impl_->contexts.abandon();
        impl_->drawing = false;
    }
}

// ---- Options ------------------------------------------------------------------------------------

const Options& AmbientOcclusion::options() const {
    return impl_->options;
}

AoStatus AmbientOcclusion::setOptions(const Options& options) {
    AoStatus status = impl_->checkNotInCallback();
    if (status) {
        status = checkOptions(options);
    }
    if (!status) {
        return impl_->report(std::move(status));
    }
    const Options before = std::exchange(impl_->options, options);
    const EffectiveOptions effectiveBefore = impl_->effective;
    impl_->resolveOptions();
    if (before.backbone == options.backbone) {
        const gl::ContextScope scope(impl_->contexts); // elsewhere, what is dropped waits
        impl_->backbone->optionsChanged(effectiveBefore.get());
        return {};
    }
    status = impl_->onKnownState([&](const gl::StateGuard& /*guard*/) { return impl_->build(); });
    if (!status) {
        impl_->options = before;
        impl_->effective = effectiveBefore;
    }
    return impl_->report(std::move(status));
}

void AmbientOcclusion::setTexelTracer(std::unique_ptr<AbstractTexelTracer> tracer) {
    if (!impl_->report(impl_->checkNotInCallback())) {
        return;
    }
    const gl::ContextScope scope(impl_->contexts); // elsewhere, what is dropped waits
    impl_->backbone->dropTracer();
    impl_->tracer = std::move(tracer);
}

// ---- Scene definition ---------------------------------------------------------------------------

AoStatus AmbientOcclusion::meshBegin() {
    return impl_->report(impl_->builder.begin());
}
AoStatus AmbientOcclusion::aoNormal3f(float x, float y, float z) {
    return impl_->report(impl_->builder.normal({x, y, z}));
}
AoStatus AmbientOcclusion::aoVertex3f(float x, float y, float z) {
    return impl_->report(impl_->builder.vertex({x, y, z}));
}
AoStatus AmbientOcclusion::aoBegin(AoPrimitive primitive) {
    return impl_->report(impl_->builder.beginRun(primitive));
}
AoStatus AmbientOcclusion::aoVertexIndex(std::uint32_t index) {
    return impl_->report(impl_->builder.index(index));
}
AoStatus AmbientOcclusion::aoEnd() {
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

AoStatus AmbientOcclusion::replaceMesh(MeshId id, const MeshData& data) {
    Result<Mesh> mesh = makeMesh(data);
    if (!mesh) {
        return impl_->report(mesh.status());
    }
    return impl_->report(impl_->scene.replace(id, std::move(*mesh)));
}

AoStatus AmbientOcclusion::moveMesh(MeshId id, const glm::mat4& transform) {
    return impl_->report(impl_->scene.move(id, transform));
}

AoStatus AmbientOcclusion::removeMesh(MeshId id) {
    return impl_->report(impl_->scene.remove(id));
}

AoStatus AmbientOcclusion::setSceneRenderer(SceneRenderer renderer, const glm::vec3& min,
                                            const glm::vec3& max) {
    if (AoStatus status = impl_->checkNotInCallback(); !status) {
        return impl_->report(std::move(status));
    }
    if (!renderer) {
        impl_->renderer = nullptr;
        impl_->scene.setDrawn({});
        impl_->backbone->rendererChanged();
        return {};
    }
    const Bounds box{min, max};
    if (AoStatus status = checkBox(box); !status) {
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

AoStatus AmbientOcclusion::aoSceneChanged(const glm::vec3& min, const glm::vec3& max) {
    const Bounds box{min, max};
    AoStatus status = checkBox(box);
    if (status && !impl_->scene.drawn()) {
        status = {StatusCode::NoScene,
                  "aoSceneChanged: no scene renderer is set; call setSceneRenderer first"};
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
            AoStatus(StatusCode::InvalidPosition, "the position of a cube map must be finite"));
    }
    return impl_->report(
        impl_->withCubeMaps([&](BackboneCubemapped& to) { return to.addCubeMap(position); }));
}

AoStatus AmbientOcclusion::removeCubeMap(CubeMapId id) {
    return impl_->report(
        impl_->withCubeMaps([&](BackboneCubemapped& to) { return to.removeCubeMap(id); }));
}

AoStatus AmbientOcclusion::clear() {
    return impl_->report(impl_->guarded([&](AbstractBackbone& to) {
        if (BackboneCubemapped* cubemapped = to.cubemapped()) {
            cubemapped->clear();
        }
        return AoStatus();
    }));
}

std::vector<CubeMapInfo> AmbientOcclusion::cubeMaps() const {
    const gl::ContextScope scope(impl_->contexts); // elsewhere, times stay as they were
    BackboneCubemapped* cubemapped = impl_->backbone->cubemapped();
    return cubemapped != nullptr ? cubemapped->cubeMaps() : std::vector<CubeMapInfo>();
}

// ---- Frame --------------------------------------------------------------------------------------

AoStatus AmbientOcclusion::aoSetCamera(const glm::mat4& view, const glm::mat4& projection) {
    return impl_->report(impl_->view.setCamera(view, projection));
}

AoStatus AmbientOcclusion::aoDrawBegin() {
    if (AoStatus status = impl_->checkNotInCallback(); !status) {
        return impl_->report(std::move(status));
    }
    if (impl_->drawing) {
        return impl_->report({StatusCode::InvalidCallOrder,
                              "aoDrawBegin: a frame has already begun; call aoDrawEnd first"});
    }
    if (AoStatus status = impl_->contexts.check(); !status) {
        return impl_->report(std::move(status));
    }
    impl_->drawing = true;
    impl_->view.begin(impl_->gl);
    return {};
}

AoStatus AmbientOcclusion::aoDrawEnd(float x, float y, float z, ViewId id) {
    if (AoStatus status = impl_->checkNotInCallback(); !status) {
        return impl_->report(std::move(status));
    }
    if (!impl_->drawing) {
        if (AoStatus status = impl_->contexts.check(); !status) { // explains why aoDrawBegin failed
            return impl_->report(std::move(status));
        }
        return impl_->report({StatusCode::InvalidCallOrder,
                              "aoDrawEnd: no frame has begun; call aoDrawBegin before drawing"});
    }
    impl_->drawing = false;
    return impl_->report(impl_->drawEnd({x, y, z}, id));
}

AoStatus AmbientOcclusion::aoShade(const glm::mat4& view, const glm::mat4& projection, ViewId id) {
    AoStatus status = aoSetCamera(view, projection);
    if (status) {
        status = aoDrawBegin();
    }
    if (!status) {
        return status;
    }
    const glm::vec3 eye = impl_->view.eye();
    return aoDrawEnd(eye.x, eye.y, eye.z, id);
}

AoStatus AmbientOcclusion::removeView(ViewId id) {
    return impl_->report(impl_->guarded([&](AbstractBackbone& to) {
        to.removeView(id);
        return AoStatus();
    }));
}

AoStatus AmbientOcclusion::Impl::drawEnd(const glm::vec3& position, ViewId id) {
    return onKnownState([&](const gl::StateGuard& guard) -> AoStatus {
        Result<Frame> frame = view.frameFrom(gl, guard, position);
        if (!frame) {
            return frame.status();
        }
        if (AoStatus status = HostView::takeTarget(guard, *frame); !status) {
            return status;
        }
        frame->view = id;
        updateOptions();
        return backbone->drawEnd(*frame);
    });
}

Result<TextureName> AmbientOcclusion::aoApply(const HostTextures& textures,
                                              const glm::vec3& position, ViewId id) {
    if (AoStatus status = impl_->checkNotInCallback(); !status) {
        return impl_->report(std::move(status));
    }
    return impl_->report(impl_->apply(textures, position, id));
}

Result<TextureName> AmbientOcclusion::Impl::apply(const HostTextures& textures,
                                                  const glm::vec3& position, ViewId id) {
    return onKnownState([&](const gl::StateGuard& guard) -> Result<TextureName> {
        Result<Frame> frame = view.frameFrom(gl, guard, position);
        if (!frame) {
            return frame.status();
        }
        frame->srgb = guard.hostSrgb();
        frame->view = id;
        updateOptions();
        return backbone->apply(*frame, textures);
    });
}

// ---- Results ------------------------------------------------------------------------------------

Statistics AmbientOcclusion::statistics() const {
    const gl::ContextScope scope(impl_->contexts); // elsewhere, times stay as they were
    Statistics statistics = impl_->backbone->statistics();
    statistics.estimator = impl_->effective.get().estimator;
    setFormerNames(statistics);
    return statistics;
}

Statistics AmbientOcclusion::statistics(ViewId id) const {
    const gl::ContextScope scope(impl_->contexts);
    Statistics statistics = impl_->backbone->statistics(id);
    statistics.estimator = impl_->effective.get().estimator;
    setFormerNames(statistics);
    return statistics;
}

Result<VisibilityImage> AmbientOcclusion::readVisibility(ViewId id) {
    return impl_->report(
        impl_->guarded([&](AbstractBackbone& to) { return to.readVisibility(id); }));
}

Result<VisibilityImage> AmbientOcclusion::readVisibility() {
    return impl_->report(impl_->guarded([&](AbstractBackbone& to) { return to.readVisibility(); }));
}

Result<CubeMapImage> AmbientOcclusion::readCubeMap(CubeMapId id) {
    return impl_->report(
        impl_->withCubeMaps([&](BackboneCubemapped& to) { return to.readCubeMap(id); }));
}

const AoStatus& AmbientOcclusion::lastStatus() const {
    return impl_->lastStatus;
}
void AmbientOcclusion::setMessageSink(MessageSink sink) {
    impl_->sink = std::move(sink);
}

} // namespace aolib
