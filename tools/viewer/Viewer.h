#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/Failure.h"
#include "viewer/ComparedPicture.h"
#include "viewer/CubeMapGizmos.h"
#include "viewer/GizmoDrag.h"
#include "viewer/Gui.h"
#include "viewer/Messages.h"
#include "viewer/SceneLoader.h"
#include "viewer/SidePanel.h"
#include "viewer/ViewerSettings.h"
#include "viewer/Window.h"

namespace aolib::viewer {

/// The window of "aolib view": a host like any other, with sliders beside its picture. Draws when
/// something has changed and waits else. Thread: main only.
class Viewer {
public:
    /// Opens the window. Errors: Graphics, BadInput (what the library rejects of the scene).
    static Result<std::unique_ptr<Viewer>, app::Failure> open(ViewerSettings settings);

    /// Until the window is closed, or what the settings say is done. Errors: Failed (a file that
    /// could not be written), Graphics (the driver complained, where that counts).
    app::MaybeFailure run();

private:
    Viewer(ViewerSettings settings, std::unique_ptr<Window> window, std::unique_ptr<Gui> gui,
           ComparedPicture picture);
    app::MaybeFailure adopt(app::View view);
    Options optionsFor(const app::View& view) const;

    app::MaybeFailure step();
    double timing() const;
    void follow(const Input& input, float seconds);
    void takeScene();
    void followTruth();
    void followLight();
    References references() const;
    void drawPicture();
    void drawGui();
    app::MaybeFailure saveWhatIsDue();
    PanelFacts facts() const;

    void execute(Command command);
    void execute(const PanelActions& actions);
    void goToCamera(const NamedCamera& camera);
    void openScene(const std::string& nameOrPath);
    void changeCubeMaps(Command command);
    void followGizmos(const Input& input);
    void moveCubeMap(const GizmoDrag::Move& move);
    void drawMarks(const glm::vec2& size);
    app::MaybeFailure saveScreenshot(const std::filesystem::path& file) const;
    void exportCase();
    app::MaybeFailure writeState();
    bool ending() const;
    bool settled() const;

    float panelWidth() const { return state_.panel ? panel_.width() : 0.0F; }
    glm::vec2 pictureSize() const; ///< mouse pixels
    glm::ivec2 picturePixels() const;

    ViewerSettings settings_;
    std::unique_ptr<Window> window_; ///< first: its context outlives what was made in it
    std::unique_ptr<Gui> gui_;
    bench::PassTimer timer_;
    ComparedPicture picture_;
    std::unique_ptr<SceneInstance> scene_;
    TruthWorker truth_;
    LightWorker lightWorker_;
    SceneLoader loader_;
    SidePanel panel_;
    Messages messages_;
    FrameTimes times_;
    ViewerState state_;
    TruthWorker::State truthState_;
    LightWorker::State lightState_;
    std::shared_ptr<const lighting::EnvironmentMap> environment_;
    std::string environmentName_; ///< whose that is; empty for none yet
    std::vector<Gizmo> gizmos_;
    GizmoDrag drag_;
    std::size_t nextCamera_ = 0;
    bool grabbed_ = false; ///< the left button went down on a mark or the split line
    bool moving_ = false;  ///< the camera was, in the latest frame
    int guiFrames_ = 0;    ///< to be drawn until ImGui has come to rest
    int frames_ = 0;
    double drawSeconds_ = 0.0; ///< of the latest picture
    std::chrono::steady_clock::time_point latestPicture_;
    std::chrono::steady_clock::time_point latestStep_;
    bool screenshotWanted_ = false;
};

} // namespace aolib::viewer
