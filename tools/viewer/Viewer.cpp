#include "viewer/Viewer.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <glm/common.hpp>

#include "viewer/Overlays.h"

namespace aolib::viewer {

namespace {

using Clock = std::chrono::steady_clock;

constexpr float kPanelWidth = 340.0F; ///< mouse pixels where text has its ordinary size
/// Frames that ImGui needs after an event until what it shows is what it will show.
constexpr int kGuiFrames = 3;
/// The longest pause between pictures of a view at rest that gets better, so that worker threads
/// have the processor; and between looks at the progress of the truth. Seconds.
constexpr double kLongestPause = 0.05;
constexpr double kTruthPause = 0.1;
/// While the panel is used, a picture that only gets better is drawn after so many times as long.
constexpr double kHandsFirst = 3.0;

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

} // namespace

Result<std::unique_ptr<Viewer>, app::Failure> Viewer::open(ViewerSettings settings) {
    const int panel = settings.panel ? static_cast<int>(kPanelWidth) : 0;
    auto window =
        Window::open({settings.view.width + panel, settings.view.height, settings.strict});
    if (!window) {
        return window.error();
    }
    auto gui = Gui::create(**window);
    if (!gui) {
        return app::graphicsFailure(gui.status().message());
    }
    const float scale = (*window)->contentScale();
    if (scale > 1.0F) {
        (*window)->resize(
            {settings.view.width + static_cast<int>(scale) * panel, settings.view.height});
    }
    auto picture = ComparedPicture::create((*window)->session().gl());
    if (!picture) {
        return app::graphicsFailure(picture.status().message());
    }
    app::View first = std::move(settings.view);
    std::unique_ptr<Viewer> viewer(
        new Viewer(std::move(settings), std::move(*window), std::move(*gui), std::move(*picture)));
    if (auto failure = viewer->adopt(std::move(first))) {
        return *failure;
    }
    return viewer;
}

Viewer::Viewer(ViewerSettings settings, std::unique_ptr<Window> window, std::unique_ptr<Gui> gui,
               ComparedPicture picture)
    : settings_(std::move(settings)), window_(std::move(window)), gui_(std::move(gui)),
      picture_(std::move(picture)), truth_(&Window::wake),
      lightWorker_(&Window::wake, settings_.light), loader_(&Window::wake),
      panel_(settings_.options, kPanelWidth * window_->contentScale()) {
    state_.options = settings_.options;
    state_.camera.mode = settings_.mode;
    state_.compared = settings_.compared;
    state_.split.place(settings_.split);
    state_.truthRays = settings_.truthRays;
    state_.environment = settings_.environment;
    state_.turn = settings_.turn;
    state_.panel = settings_.panel;
    state_.help = settings_.help;
    state_.gizmos = settings_.gizmos;
    if (!settings_.invited) {
        messages_.tell("A generated scene. Drop a .glb, .gltf or .obj file, or a case, to see it "
                       "here; F1 shows all keys.");
    }
}

/// The options that go with a scene: lengths follow its size, unless it says what they are.
Options Viewer::optionsFor(const app::View& view) const {
    Options options = state_.options;
    if (view.options.radius > 0.0F) {
        options.radius = view.options.radius;
        options.falloff = view.options.falloff;
    } else if (scene_) {
        options.radius *= static_cast<float>(view.diagonal / scene_->view().diagonal);
    }
    return options;
}

/// A failure leaves the old scene.
app::MaybeFailure Viewer::adopt(app::View view) {
    const Options options = optionsFor(view);
    auto staged = SceneInstance::create(window_->session(), timer_, std::move(view));
    if (!staged) {
        return staged.error();
    }
    scene_ = std::move(*staged);
    const app::View& adopted = scene_->view();
    state_.options = options;
    Options defaults = panel_.defaults();
    defaults.radius = options.radius;
    panel_.setDefaults(defaults);
    state_.camera.begin(adopted.camera, scene_->bounds(), static_cast<float>(adopted.diagonal));
    state_.chosen.reset();
    drag_.cancel();
    state_.error.reset();
    nextCamera_ = 0;
    truth_.setScene(adopted.model.flattened());
    lightWorker_.stop();
    times_.clear();
    picture_.forget();
    guiFrames_ = kGuiFrames;
    window_->setTitle(adopted.model.name + " - aolib view");
    return std::nullopt;
}

app::MaybeFailure Viewer::run() {
    app::MaybeFailure failure;
    while (!failure && !ending()) {
        failure = step();
    }
    return failure ? failure : window_->session().reviewMessages();
}

bool Viewer::settled() const {
    return picture_.settled() && !truthState_.working && !lightState_.working && !loader_.busy() &&
           guiFrames_ == 0 && frames_ > kGuiFrames;
}

bool Viewer::ending() const {
    return window_->closing() || (settings_.frames && frames_ >= *settings_.frames) ||
           (settings_.settle && settled());
}

/// Seconds to wait for an event; below 0 without an end.
double Viewer::timing() const {
    if (settings_.frames || guiFrames_ > 0 || moving_) {
        return 0.0;
    }
    if (!picture_.settled()) {
        return std::min(drawSeconds_, kLongestPause);
    }
    if (settings_.settle || truthState_.working || lightState_.working || loader_.busy()) {
        return kTruthPause;
    }
    return messages_.secondsLeft();
}

app::MaybeFailure Viewer::step() {
    window_->wait(timing());
    guiFrames_ = window_->stirred() ? kGuiFrames : std::max(guiFrames_ - 1, 0);
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - latestStep_).count();
    latestStep_ = now;
    const Input input = window_->takeInput(pictureSize().x);
    takeScene();
    follow(input, static_cast<float>(seconds));
    followTruth();
    followLight();
    drawPicture();
    drawGui();
    ++frames_;
    app::MaybeFailure failure = saveWhatIsDue();
    window_->show();
    return failure ? failure : writeState();
}

glm::vec2 Viewer::pictureSize() const {
    const glm::vec2 window(window_->size());
    return {std::max(window.x - panelWidth(), 1.0F), std::max(window.y, 1.0F)};
}

glm::ivec2 Viewer::picturePixels() const {
    const glm::vec2 window(glm::max(window_->size(), glm::ivec2(1)));
    const glm::vec2 pixels(window_->pixels());
    return glm::max(glm::ivec2(glm::round(pictureSize() * pixels / window)), glm::ivec2(1));
}

void Viewer::takeScene() {
    if (auto opened = loader_.take()) {
        if (!*opened) {
            messages_.warn(opened->error().sentence);
        } else if (const auto failure = adopt(std::move(**opened))) {
            messages_.warn(failure->sentence);
        }
        guiFrames_ = kGuiFrames;
    }
}

void Viewer::follow(const Input& input, float seconds) {
    for (const KeyPress& press : input.keys) {
        if (const KeyBinding* binding = bindingOf(press)) {
            execute(binding->command);
        }
    }
    if (!input.dropped.empty()) {
        openScene(input.dropped.front());
    }
    const glm::vec2 size = pictureSize();
    const ButtonDrag& left = input.of(MouseButton::Left);
    if (state_.compared != ComparedMethod::None) {
        state_.split.follow(left, size.x);
    }
    if (left.pressed) {
        grabbed_ = state_.split.dragging();
    }
    followGizmos(input);
    moving_ = state_.camera.follow(input, size.y, seconds, !grabbed_);
}

void Viewer::followTruth() {
    if (!needsTruth(state_.compared)) {
        truth_.stop();
    } else {
        const NamedCamera& camera = state_.camera.camera();
        const glm::ivec2 pixels = picturePixels();
        TruthRequest request;
        request.camera.view = glm::dmat4(viewMatrix(camera));
        request.camera.projection = glm::dmat4(
            projectionMatrix(camera, static_cast<float>(pixels.x) / static_cast<float>(pixels.y)));
        request.camera.width = pixels.x;
        request.camera.height = pixels.y;
        request.radius = static_cast<double>(state_.options.radius);
        request.falloff = state_.options.falloff;
        request.normals = scene_->view().normals == host::SceneNormals::Model
                              ? NormalSource::Given
                              : NormalSource::Geometric;
        request.rays = state_.truthRays;
        truth_.follow(request);
    }
    truthState_ = truth_.state();
}

void Viewer::drawPicture() {
    const Clock::time_point begin = Clock::now();
    // Where pictures take long, the panel is not to be slow because of one that only gets better.
    const bool busyHands = guiFrames_ > 0 && !settings_.frames;
    if (busyHands && secondsSince(latestPicture_) < kHandsFirst * drawSeconds_ &&
        !picture_.outdated(state_, picturePixels(), references())) {
        return;
    }
    const Result<bool> drawn =
        picture_.draw(*scene_, state_, picturePixels(), references(), times_);
    if (!drawn) {
        messages_.warn(drawn.status().message());
        guiFrames_ = kGuiFrames;
        if (drawn.status().code() == StatusCode::InvalidOption) {
            state_.options = scene_->ao().options(); // as they were
        }
    } else if (*drawn) {
        drawSeconds_ = secondsSince(begin);
        latestPicture_ = Clock::now();
    }
}

void Viewer::drawGui() {
    const glm::vec2 size = pictureSize();
    PanelActions actions;
    gui_->beginFrame();
    drawMarks(size);
    if (state_.compared != ComparedMethod::None) {
        drawSplit(state_.split, size, state_.occlusion ? "aolib" : "without ambient occlusion",
                  std::string(choiceOf(state_.compared).label));
    }
    if (state_.panel) {
        panel_.draw(size.x, size.y, state_, facts(), actions);
    }
    messages_.draw(size);
    if (state_.help) {
        drawHelp(size, glm::vec2(window_->size()));
    }
    const gl::Functions& gl = window_->session().gl();
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    picture_.present(state_);
    gl.Viewport(0, 0, window_->pixels().x, window_->pixels().y);
    gui_->endFrame();
    execute(actions);
}

PanelFacts Viewer::facts() const {
    const app::View& view = scene_->view();
    PanelFacts facts;
    facts.scene = view.scene;
    facts.triangles = scene_->triangles();
    facts.sceneSize = static_cast<float>(view.diagonal);
    facts.cameras = scene_->cameras();
    facts.loading = loader_.busy();
    facts.statistics = scene_->ao().statistics();
    facts.cubeMaps = scene_->ao().cubeMaps();
    facts.truth = truthState_;
    facts.light = lightState_;
    facts.times = &times_;
    facts.device = window_->session().describe();
    return facts;
}

} // namespace aolib::viewer
