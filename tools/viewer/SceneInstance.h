#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <aolib/AmbientOcclusion.h>

#include "app/GlSession.h"
#include "app/View.h"
#include "bench/PassTimer.h"
#include "host/HostFramebuffer.h"
#include "host/HostRenderer.h"
#include "scene/Bounds.h"

namespace aolib::viewer {

/// A scene, described to the library and ready to be drawn, with and without ambient occlusion, by
/// the backbone that is asked for or in screen space. Context: the window's, for every call.
class SceneInstance {
public:
    /// @param session,timer  must outlive it. Errors: Graphics, BadInput.
    static Result<std::unique_ptr<SceneInstance>, app::Failure>
    create(const app::GlSession& session, bench::PassTimer& timer, app::View view);

    /// Takes a camera for the frames to come. @param aspect  width by height.
    void look(const NamedCamera& camera, float aspect);

    /// As the host draws it.
    void drawPlain(const host::HostFramebuffer& target);
    /// Darkened. @param measured  if not null, it gets what each pass took, the GPU waited for.
    AoStatus drawShaded(const host::HostFramebuffer& target, const Options& options,
                        std::vector<bench::PassTime>* measured);
    /// Darkened in screen space by the same options, as far as they have a meaning there.
    AoStatus drawScreenSpace(const host::HostFramebuffer& target, const Options& options);

    const app::GlSession& session() const { return *session_; }
    /// Of the camera that it looks with.
    const glm::mat4& viewMatrix() const { return viewMatrix_; }
    const glm::mat4& projection() const { return projection_; }

    const app::View& view() const { return view_; }
    const Bounds& bounds() const { return bounds_; }
    std::size_t triangles() const { return triangles_; }
    const std::vector<NamedCamera>& cameras() const { return cameras_; }
    AmbientOcclusion& ao() { return ao_; }
    const AmbientOcclusion& ao() const { return ao_; }
    /// Says that cube maps were placed or removed by hand.
    void touch() { changed_ = true; }
    /// Whether another shaded frame of the same camera and options would show the same.
    bool settled() const;

private:
    SceneInstance(const app::GlSession& session, bench::PassTimer& timer, app::View view,
                  AmbientOcclusion ao, host::HostRenderer renderer);
    AoStatus drawWith(AmbientOcclusion& ao, const host::HostFramebuffer& target,
                      std::vector<bench::PassTime>* measured);
    AoStatus openScreenSpace(const Options& options);
    void finish() const;

    const app::GlSession* session_;
    bench::PassTimer* timer_;
    app::View view_;
    Bounds bounds_;
    std::size_t triangles_;
    std::vector<NamedCamera> cameras_;
    AmbientOcclusion ao_;
    std::optional<AmbientOcclusion> screenSpace_; ///< made when it is first asked for
    host::HostRenderer renderer_;
    glm::vec3 eye_{0.0F};
    glm::mat4 viewMatrix_{1.0F};
    glm::mat4 projection_{1.0F};
    std::uint64_t changedFrame_ = 0; ///< the first frame that shows the latest change
    bool changed_ = true;
};

/// The same options for the screen-space backbone, which knows no rays.
Options inScreenSpace(Options options);

} // namespace aolib::viewer
