#include "viewer/SidePanel.h"

#include <algorithm>
#include <filesystem>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "content/generated/Environments.h"
#include "content/generated/GeneratedScenes.h"
#include "viewer/FrameGraph.h"

namespace aolib::viewer {

namespace {

constexpr int kFewestRays = 16;
constexpr int kMostRays = 4096;
constexpr double kMegabyte = 1e6;

bool section(const char* name, bool open = true) {
    return ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

/// A button for a command, with its key.
void button(const char* text, Command command, PanelActions& actions) {
    if (ImGui::Button(text)) {
        actions.command(command);
    }
    if (ImGui::IsItemHovered()) {
        const KeyBinding& binding = bindingOf(command);
        ImGui::SetTooltip("%s (%s)", binding.help, binding.name);
    }
}

void drawTruth(ViewerState& state, const TruthWorker::State& truth) {
    ImGui::SetNextItemWidth(-7.0F * ImGui::GetFontSize());
    ImGui::SliderInt("rays of truth", &state.truthRays, kFewestRays, kMostRays, "%d",
                     ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
    if (!truth.failure.empty()) {
        ImGui::TextWrapped("%s", truth.failure.c_str());
        return;
    }
    const int rays = truth.truth ? truth.truth->rays : 0;
    const std::string text =
        truth.working && rays == 0 ? "tracing" : std::to_string(rays) + " rays per pixel";
    ImGui::ProgressBar(truth.progress, {-1.0F, 0.0F}, text.c_str());
    if (state.error && truth.truth) {
        ImGui::Text("RMSE %.4f, bias %+.4f", state.error->rmse, state.error->bias);
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("of W against this truth, whose own noise is %.4f and taken off",
                              truth.truth->noise);
        }
    } else {
        ImGui::TextDisabled("RMSE: once there is a truth");
    }
}

void drawLight(ViewerState& state, const LightWorker::State& light) {
    ImGui::SetNextItemWidth(-1.0F);
    const std::string shown = std::filesystem::path(state.environment).filename().string();
    if (ImGui::BeginCombo("##environment", shown.c_str())) {
        for (const GeneratedEnvironment& environment : generatedEnvironments()) {
            if (ImGui::Selectable(environment.name, state.environment == environment.name)) {
                state.environment = environment.name;
            }
        }
        ImGui::EndCombo();
    }
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("or drop a Radiance file, .hdr");
    }
    ImGui::SetNextItemWidth(-7.0F * ImGui::GetFontSize());
    ImGui::SliderFloat("turned", &state.turn, -180.0F, 180.0F, "%.0f degrees",
                       ImGuiSliderFlags_AlwaysClamp);
    ImGui::SetNextItemWidth(-7.0F * ImGui::GetFontSize());
    ImGui::SliderFloat("exposure", &state.stops, -4.0F, 4.0F, "%+.1f stops",
                       ImGuiSliderFlags_AlwaysClamp);
    if (!light.failure.empty()) {
        ImGui::TextWrapped("%s", light.failure.c_str());
    } else if (light.scene) {
        ImGui::TextDisabled("%zu vertices, baked in %.1f s", light.scene->vertices(),
                            light.scene->bakeSeconds);
    } else {
        ImGui::ProgressBar(light.progress, {-1.0F, 0.0F}, "baking vertices");
    }
}

void megabytes(const char* what, std::size_t bytes) {
    ImGui::Text("%-12s %8.1f MB", what, static_cast<double>(bytes) / kMegabyte);
}

} // namespace

void SidePanel::draw(float left, float height, ViewerState& state, const PanelFacts& facts,
                     PanelActions& actions) {
    ImGui::SetNextWindowPos({left, 0.0F}, ImGuiCond_Always);
    ImGui::SetNextWindowSize({width_, height}, ImGuiCond_Always);
    ImGui::Begin("##panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    drawScene(state, facts, actions);
    if (section("Compare")) {
        drawComparison(state, facts);
    }
    if (section("Measurements")) {
        drawMeasurements(state, facts);
    }
    if (section("Options")) {
        options_.draw(state.options, defaults_, facts.sceneSize);
    }
    if (section("Cube maps")) {
        drawCubeMapList(state, facts, actions);
    }
    ImGui::End();
}

void SidePanel::drawScene(ViewerState& state, const PanelFacts& facts, PanelActions& actions) {
    const std::string name = std::filesystem::path(facts.scene).filename().string();
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::BeginCombo("##scene", (name + (facts.loading ? ", opening another" : "")).c_str())) {
        for (const GeneratedScene& scene : generatedScenes()) {
            if (ImGui::Selectable(scene.name, facts.scene == scene.name)) {
                actions.open = scene.name;
            }
        }
        ImGui::EndCombo();
    }
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::InputTextWithHint("##path", "or a file: drop it, or type its path", &path_,
                                 ImGuiInputTextFlags_EnterReturnsTrue) &&
        !path_.empty()) {
        actions.open = path_;
    }
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 size = ImGui::GetItemRectSize();
    pathPlace_ = {low.x, low.y, size.x, size.y};
    ImGui::TextDisabled("%zu triangles, %.4g across", facts.triangles,
                        static_cast<double>(facts.sceneSize));
    bool walking = state.camera.mode == CameraMode::Walk;
    if (ImGui::Checkbox("walk", &walking)) {
        state.camera.mode = walking ? CameraMode::Walk : CameraMode::Orbit;
    }
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::BeginCombo("##camera", "cameras")) {
        for (const NamedCamera& camera : facts.cameras) {
            if (ImGui::Selectable(camera.name.c_str())) {
                actions.camera = camera.name;
            }
        }
        ImGui::EndCombo();
    }
    button("Screenshot", Command::Screenshot, actions);
    ImGui::SameLine();
    button("Save case", Command::ExportCase, actions);
    ImGui::SameLine();
    button("Reset", Command::ResetCamera, actions);
    ImGui::SameLine();
    button("Help", Command::Help, actions);
}

void SidePanel::drawComparison(ViewerState& state, const PanelFacts& facts) {
    ImGui::Checkbox("ambient occlusion", &state.occlusion);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("with");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1.0F);
    if (ImGui::BeginCombo("##compared", std::string(choiceOf(state.compared).label).c_str())) {
        for (const ComparedMethodChoice& choice : kComparedMethods) {
            if (ImGui::Selectable(std::string(choice.label).c_str(),
                                  choice.value == state.compared)) {
                state.compared = choice.value;
            }
        }
        ImGui::EndCombo();
    }
    if (needsTruth(state.compared)) {
        drawTruth(state, facts.truth);
    }
    if (state.compared == ComparedMethod::Environment) {
        drawLight(state, facts.light);
    }
}

void SidePanel::drawMeasurements(ViewerState& state, const PanelFacts& facts) const {
    ImGui::Checkbox("time each pass", &state.measuring);
    if (ImGui::IsItemHovered()) {
        ImGui::SetTooltip("waits for the GPU after every pass, which makes frames a little longer");
    }
    if (state.measuring && facts.times != nullptr && !facts.times->frames().empty()) {
        drawFrameGraph(*facts.times);
    }
    const Statistics& statistics = facts.statistics;
    if (statistics.coverage >= 0.0F) {
        ImGui::Text("coverage     %7.1f %%", 100.0 * static_cast<double>(statistics.coverage));
    } else {
        ImGui::TextUnformatted("coverage     not known");
    }
    ImGui::Text("computed     %7.1f %%%s",
                100.0 * std::min(static_cast<double>(statistics.computed), 1.0),
                statistics.converged ? ", at rest" : "");
    megabytes("cube maps", statistics.bytesKept);
    megabytes("on their way", statistics.bytesBuilding);
    megabytes("frame", statistics.bytesFrame);
    megabytes("triangles", statistics.bytesScene);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextDisabled("%s", facts.device.c_str());
    ImGui::PopTextWrapPos();
}

void drawCubeMapList(ViewerState& state, const PanelFacts& facts, PanelActions& actions) {
    ImGui::Checkbox("mark them", &state.gizmos);
    ImGui::SameLine();
    button("Place here", Command::PlaceCubeMap, actions);
    ImGui::SameLine();
    button("Remove", Command::RemoveCubeMap, actions);
    ImGui::SameLine();
    button("All", Command::ClearCubeMaps, actions);
    for (const CubeMapInfo& cubeMap : facts.cubeMaps) {
        char text[96];
        std::snprintf(text, sizeof text, "%u: %d faces of %d^2, %.1f MB",
                      static_cast<unsigned>(cubeMap.id), cubeMap.facesModelled, cubeMap.faceSize,
                      static_cast<double>(cubeMap.bytes) / kMegabyte);
        const bool chosen = state.chosen == cubeMap.id;
        if (ImGui::Selectable(text, chosen)) {
            state.chosen = chosen ? std::nullopt : std::optional(cubeMap.id);
            state.gizmos = true;
        }
        if (ImGui::IsItemHovered()) {
            const glm::vec3& p = cubeMap.position;
            ImGui::SetTooltip("at %.4g, %.4g, %.4g; %d layers; %.0f ms of the frames' time so far",
                              static_cast<double>(p.x), static_cast<double>(p.y),
                              static_cast<double>(p.z), cubeMap.layers, cubeMap.buildMs);
        }
    }
}

} // namespace aolib::viewer
