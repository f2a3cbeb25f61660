#pragma once

#include <optional>
#include <string>

#include "app/View.h"
#include "bench/environment/LitScene.h"
#include "viewer/CameraControl.h"
#include "viewer/ComparedMethod.h"

namespace aolib::viewer {

/// What the command line says.
struct ViewerSettings {
    app::View view;      ///< the first scene; its size is that of the picture beside the panel
    Options options;     ///< of the first scene, the radius above 0
    bool invited = true; ///< the scene was the user's wish; else the window says what may be done
    ComparedMethod compared = ComparedMethod::None;
    float split = 0.5F;
    int truthRays = 256;
    std::string environment = "sunny"; ///< that "environment" compares with
    float turn = 0.0F;                 ///< of it about +Y, degrees
    bench::LitSceneOptions light;      ///< how vertices are baked for it
    CameraMode mode = CameraMode::Orbit;
    bool panel = true;
    bool help = false;
    bool gizmos = false;
    std::string folder = ".";  ///< for what keys save
    std::optional<int> frames; ///< after so many it ends
    bool settle = false;       ///< when nothing is left to compute it ends
    std::string screenshot;    ///< written at the end; empty for none
    std::string stateFile;     ///< kept up to date; empty for none
    bool strict = false;       ///< the driver's messages are failures
};

} // namespace aolib::viewer
