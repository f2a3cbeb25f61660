#pragma once

#include <optional>
#include <string>
#include <vector>

#include <aolib/Options.h>
#include <aolib/Scene.h>

#include "viewer/CameraControl.h"
#include "viewer/Command.h"
#include "viewer/ComparedMethod.h"
#include "viewer/SplitLine.h"
#include "viewer/ViewError.h"

namespace aolib::viewer {

/// What the user has chosen.
struct ViewerState {
    CameraControl camera;
    Options options;
    bool occlusion = true; ///< off: the left part is the host's picture, too
    ComparedMethod compared = ComparedMethod::None;
    SplitLine split;
    int truthRays = 256;               ///< per pixel
    std::string environment = "sunny"; ///< that lights the right part: a generated one, or a file
    float turn = 0.0F;                 ///< of the environment about +Y, degrees
    float stops = 0.0F;                ///< of exposure, under the environment
    bool panel = true;                 ///< shown
    bool help = false;                 ///< shown
    bool gizmos = false;               ///< cube maps are marked
    bool measuring = true;             ///< frames are timed pass by pass
    std::optional<CubeMapId> chosen;   ///< cube map
    std::optional<ViewError> error;    ///< of the left part, where there is a truth
};

/// What panels and overlays want done, besides what they change in the state.
struct PanelActions {
    std::vector<Command> commands;
    std::optional<std::string> open;   ///< a scene, or a file
    std::optional<std::string> camera; ///< of the scene, by name

    void command(Command which) { commands.push_back(which); }
};

} // namespace aolib::viewer
