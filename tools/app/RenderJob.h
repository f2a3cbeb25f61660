#pragma once

#include <vector>

#include <aolib/Options.h>
#include <aolib/Status.h>
#include <glm/vec3.hpp>

#include "app/Failure.h"
#include "app/GlSession.h"
#include "app/Progress.h"
#include "content/Model.h"
#include "content/NamedCamera.h"
#include "host/ModelScene.h"
#include "image/Image.h"

namespace aolib::app {

/// What to render with ambient occlusion.
struct RenderJob {
    NamedCamera camera;
    int width = 960;  ///< pixels
    int height = 540; ///< pixels
    int samples = 0;  ///< of the host's framebuffer, per pixel; 0 for none
    Options options;
    host::SceneNormals normals = host::SceneNormals::Geometric;
    std::vector<glm::vec3> cubeMaps; ///< placed by hand before the first frame, world units
    int frames = 3;                  ///< drawn before the timed ones; more while cube maps appear
    std::vector<DebugView> debugViews;
};

/// Pictures and numbers of a job. Times are wall clock with glFinish(), milliseconds.
struct RenderResult {
    ByteImage colour;                     ///< as the host draws it
    ByteImage composite;                  ///< darkened by ambient occlusion
    FloatImage visibility;                ///< W, background -1
    std::vector<ByteImage> debugPictures; ///< one per debug view asked for
    std::size_t cubeMaps = 0;
    double buildMs = 0.0;         ///< all cube maps together, until they are complete
    double computingMs = -1.0;    ///< per frame, what aolib adds until all is computed, with
                                  ///< workers busy; median, -1 where that takes no frames
    double aoMs = 0.0;            ///< per frame, what aolib adds once all is computed; median
    double hostMs = 0.0;          ///< per frame, the host's own drawing in those; median
    double coverage = -1;         ///< share of shaded pixels, -1 where not known
    std::size_t bytesKept = 0;    ///< GPU memory of all cube maps
    std::size_t bytesCapture = 0; ///< the most that one took while it was computed
};

/// Renders a model. Errors: Graphics, BadInput (what the library rejects of options and scene).
Result<RenderResult, Failure> render(const GlSession& session, const Model& model,
                                     const RenderJob& job, Progress& progress);

/// The failure that a status of the library means to the shell.
Failure failureOf(const AoStatus& status);

} // namespace aolib::app
