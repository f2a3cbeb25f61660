#pragma once

#include <optional>
#include <string>

#include <aolib/aolib.h>

#include "content/Model.h"
#include "content/NamedCamera.h"
#include "gl/Functions.h"
#include "host/HostFramebuffer.h"
#include "host/HostRenderer.h"
#include "host/ModelScene.h"
#include "image/Image.h"

namespace aolib::test {

/// A generated scene, and one of its cameras.
struct SceneView {
    std::string scene;
    std::string camera;
};

Model buildScene(const SceneView& view);
NamedCamera cameraOf(const SceneView& view);

/// Draws a model through the public interface, as a host would. Failures are test failures.
class RenderedScene {
public:
    RenderedScene(const gl::Functions& gl, const ProcAddressLoader& loader, const Model& model,
                  const Options& options, int width, int height,
                  host::SceneNormals normals = host::SceneNormals::Geometric);

    AmbientOcclusion& ao() { return *ao_; }
    bool ready() const { return ao_ && framebuffer_ && renderer_; }

    /// One frame with ambient occlusion.
    AoStatus frame(const NamedCamera& camera);
    /// Frames until the cube map of this view stands and its coverage is known.
    AoStatus settle(const NamedCamera& camera);

    /// W of the latest frame, background -1.
    FloatImage visibility();
    /// The host's framebuffer after the latest frame, RGB.
    ByteImage composite();

private:
    int width_;
    int height_;
    std::optional<AmbientOcclusion> ao_;
    std::optional<host::HostFramebuffer> framebuffer_;
    std::optional<host::HostRenderer> renderer_;
};

} // namespace aolib::test
