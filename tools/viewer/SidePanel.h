#pragma once

#include <string>
#include <vector>

#include <aolib/Statistics.h>

#include "content/NamedCamera.h"
#include "viewer/FrameTimes.h"
#include "viewer/LightWorker.h"
#include "viewer/OptionsPanel.h"
#include "viewer/TruthWorker.h"
#include "viewer/ViewerState.h"

namespace aolib::viewer {

/// What the panel shows but does not change.
struct PanelFacts {
    std::string scene; ///< a generated scene's name, or a file
    std::size_t triangles = 0;
    float sceneSize = 1.0F; ///< its diagonal, world units
    std::vector<NamedCamera> cameras;
    bool loading = false;
    Statistics statistics;
    std::vector<CubeMapInfo> cubeMaps;
    TruthWorker::State truth;
    LightWorker::State light;
    const FrameTimes* times = nullptr;
    std::string device;
};

/// The panel beside the picture: scene, comparison, options, measurements, cube maps.
class SidePanel {
public:
    /// @param defaults  what an option goes back to.
    SidePanel(const Options& defaults, float width) : defaults_(defaults), width_(width) {}

    float width() const { return width_; } ///< mouse pixels

    /// Draws it at the right of a window of this height, from `left` on.
    void draw(float left, float height, ViewerState& state, const PanelFacts& facts,
              PanelActions& actions);

    const OptionsPanel& options() const { return options_; }
    /// Where the field for a file's path was drawn: x, y, width and height, mouse pixels.
    const glm::vec4& pathPlace() const { return pathPlace_; }
    /// Another scene, other lengths.
    void setDefaults(const Options& defaults) { defaults_ = defaults; }
    const Options& defaults() const { return defaults_; }

private:
    void drawScene(ViewerState& state, const PanelFacts& facts, PanelActions& actions);
    void drawComparison(ViewerState& state, const PanelFacts& facts);
    void drawMeasurements(ViewerState& state, const PanelFacts& facts) const;

    Options defaults_;
    float width_;
    OptionsPanel options_;
    std::string path_; ///< as far as it is typed
    glm::vec4 pathPlace_{0.0F};
};

/// The list of cube maps, with buttons, into the window that ImGui is in.
void drawCubeMapList(ViewerState& state, const PanelFacts& facts, PanelActions& actions);

} // namespace aolib::viewer
