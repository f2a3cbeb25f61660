#pragma once

#include <string>

#include "app/Failure.h"
#include "app/GlSession.h"
#include "app/Progress.h"
#include "app/ViewFlags.h"
#include "host/LitRenderer.h"

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

/// The flags of "aolib render" that light a scene by an environment instead.
struct LitFlags {
    std::string environment; ///< empty: none
    host::LitMethod method = host::LitMethod::SectorsAndSun;
    double turn = 0.0;     ///< degrees about +Y
    double exposure = 0.0; ///< per unit of radiance; 0: by the picture
    double edge = 0.5;     ///< longest edge, percent of the scene's diagonal
    int rays = 256;        ///< per vertex
    int truthRays = 1024;  ///< per pixel
    std::string picture;
    std::string truth;

    /// Adds the flags to a command. The object must outlive it.
    void attach(CLI::App& command);
    bool given() const { return !environment.empty(); }
};

/// Bakes a scene's vertices, draws it under the environment, writes and prints what was asked for.
MaybeFailure renderLit(const LitFlags& flags, const ViewFlags& view, const GlFlags& gl);

} // namespace aolib::app
