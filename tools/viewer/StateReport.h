#pragma once

#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "viewer/CubeMapGizmos.h"
#include "viewer/SidePanel.h"
#include "viewer/ViewerState.h"

namespace aolib::viewer {

/// What a report tells besides state and facts.
struct ReportFacts {
    int frames = 0;        ///< drawn with ambient occlusion or without
    glm::ivec2 picture{0}; ///< pixels
    bool settled = false;  ///< nothing is left to draw or to trace
    std::string message;   ///< the latest
    std::vector<Gizmo> gizmos;
};

/// The viewer's state as JSON, for tests and scripts.
std::string stateReport(const ViewerState& state, const PanelFacts& facts, const SidePanel& panel,
                        const ReportFacts& report);

} // namespace aolib::viewer
