#pragma once

#include <functional>
#include <string>
#include <vector>

#include <aolib/ProcAddressLoader.h>
#include <aolib/Status.h>
#include <aolib/lighting/EnvironmentMap.h>

#include "bench/environment/LitScene.h"
#include "content/NamedCamera.h"
#include "gl/Functions.h"
#include "host/LitRenderer.h"
#include "image/Image.h"

namespace aolib::bench {

/// A view of a scene that is lit.
struct EnvironmentView {
    LitScene scene; ///< its colours are not used: all is white
    NamedCamera camera;
};

/// Light with a name.
struct NamedEnvironment {
    std::string name;
    lighting::EnvironmentMap map;
};

/// What is measured: every view under every environment by every method, from traced values of each
/// pixel (what the method itself is worth) and drawn from baked values of vertices.
struct EnvironmentPlan {
    std::vector<EnvironmentView> views;
    std::vector<NamedEnvironment> environments;
    int width = 320;  ///< pixels
    int height = 180; ///< pixels
    int truthRays = 1024;
    int openingRays = 1024; ///< per pixel
    int frames = 5;         ///< timed; the median counts
};

/// A line of the table. Errors are of linear radiance, all channels, over the truth's mean.
struct EnvironmentRow {
    std::string scene;
    std::string environment;
    host::LitMethod method = host::LitMethod::Irradiance;
    bool drawn = false;   ///< from vertices, else from pixels
    double rmse = 0.0;    ///< share of the truth's mean
    double bias = 0.0;    ///< the same
    double noise = 0.0;   ///< of the truth, the same
    double frameMs = 0.0; ///< where drawn
};

/// Pictures of a view under an environment, side by side: traced, then drawn by each method that
/// is compared in them.
struct EnvironmentStrip {
    std::string scene;
    std::string environment;
    ByteImage picture;
};

struct EnvironmentFigures {
    std::vector<EnvironmentRow> rows;
    std::vector<EnvironmentStrip> strips;
};

const char* litMethodName(host::LitMethod method);

/// Measures a plan, in the current context. @param tell  hears what comes next, and how much is
/// done; false ends the run, with the rows that there are.
Result<EnvironmentFigures>
runEnvironmentPlan(const EnvironmentPlan& plan, const gl::Functions& gl,
                   const ProcAddressLoader& loader,
                   const std::function<bool(const std::string& next, double done)>& tell);

} // namespace aolib::bench
