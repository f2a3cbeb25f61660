#pragma once

#include <memory>
#include <utility>

#include <aolib/AmbientOcclusion.h>

#include "EffectiveOptions.h"
#include "HostView.h"
#include "backbone/BackboneCubemapped.h"
#include "gl/ContextGroup.h"
#include "gl/StateGuard.h"
#include "scene/SceneBuilder.h"

namespace aolib {

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

/// What an instance holds, and the ways in which its calls reach the backbone.
struct AmbientOcclusion::Impl {
    explicit Impl(const gl::Functions& functions) : gl(functions) { gl.group = &contexts; }
    /// Deletes what the current context may delete, and touches nothing of any other.
    ~Impl() { contexts.enterToDelete(); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    gl::Functions gl;
    gl::ContextGroup contexts{gl}; ///< outlives all that holds GL objects
    Options options;               ///< as the host gave them
    EffectiveOptions effective;    ///< the same, with nothing left to choose
    Scene scene;
    SceneBuilder builder;
    gl::VertexArray emptyVertexArray;
    std::unique_ptr<AbstractTexelTracer> tracer;
    SceneRenderer renderer; ///< calls the host's, and has other calls refused meanwhile
    bool rendering = false; ///< a callback of the host's runs
    std::unique_ptr<AbstractBackbone> backbone;
    HostView view;
    bool drawing = false;
    AoStatus lastStatus;
    MessageSink sink;

    BackboneContext context() {
        return {gl, emptyVertexArray, scene, effective.get(), tracer, renderer};
    }

    AoStatus report(AoStatus status) {
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

    /// Resolves the options for the scene and the tracer as they are.
    void resolveOptions() {
        gl.debugGroups = options.debugGroups;
        gl.trusted = options.trust;
        effective.resolve(options, scene, tracer != nullptr);
    }
    /// Resolves the options before the backbone works: the scene or the tracer may call for another
    /// estimator by now.
    void updateOptions() {
        const Options before = effective.get();
        resolveOptions();
        if (before.estimator != effective.get().estimator) {
            backbone->optionsChanged(before);
        }
    }

    /// Errors: InvalidCallOrder within a callback of the host's.
    AoStatus checkNotInCallback() const {
        return rendering ? AoStatus(StatusCode::InvalidCallOrder,
                                    "not allowed within a callback of the same instance")
                         : AoStatus();
    }
    /// A call that talks to GL, in a context that is known and on a known GL state.
    /// @param call  is given the guard. Errors: NoContext, WrongContext, OutOfMemory and those of
    /// the call.
    template <typename Call>
    auto onKnownState(Call call) -> decltype(call(std::declval<const gl::StateGuard&>())) {
        const gl::ContextScope scope(contexts);
        if (!scope.status()) {
            return scope.status();
        }
        const gl::StateGuard guard(gl, {options.trust, /*everything=*/renderer != nullptr});
        if (AoStatus status = contexts.makeContainers(); !status) {
            return status;
        }
        return call(guard);
    }
    /// A call to the backbone on a known GL state. Reports come after it: a message sink is the
    /// host's code and finds the host's state.
    template <typename Call>
    auto guarded(Call call) -> decltype(call(*backbone)) {
        if (AoStatus status = checkNotInCallback(); !status) {
            return status;
        }
        return onKnownState([&](const gl::StateGuard& /*guard*/) -> decltype(call(*backbone)) {
            updateOptions();
            return call(*backbone);
        });
    }

    /// A guarded call to the strategy that keeps cube maps. Errors: InvalidCallOrder for others.
    template <typename Call>
    auto withCubeMaps(Call call) -> decltype(call(std::declval<BackboneCubemapped&>())) {
        return guarded([&](AbstractBackbone& to) -> decltype(call(*to.cubemapped())) {
            BackboneCubemapped* cubemapped = to.cubemapped();
            if (cubemapped == nullptr) {
                return AoStatus(StatusCode::InvalidCallOrder,
                                "this backbone keeps no cube maps; set Options::backbone to "
                                "Backbone::Cubemapped first");
            }
            return call(*cubemapped);
        });
    }

    /// Builds the backbone that the options name. Errors: as AmbientOcclusion::create().
    AoStatus build();
    AoStatus prepare(const ProgressCallback& callback, std::span<const glm::vec3> positions);
    AoStatus report(const ProgressCallback& callback, float progress);
    AoStatus drawEnd(const glm::vec3& position, ViewId id);
    Result<TextureName> apply(const HostTextures& textures, const glm::vec3& position, ViewId id);
};

} // namespace aolib
