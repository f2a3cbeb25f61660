#include "viewer/Gui.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace aolib::viewer {

namespace {

constexpr float kRounding = 3.0F;

void dress(float scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 0.0F;
    style.FrameRounding = kRounding;
    style.GrabRounding = kRounding;
    style.Colors[ImGuiCol_WindowBg].w = 1.0F;
    style.ScaleAllSizes(scale);
    ImGui::GetIO().FontGlobalScale = scale;
}

} // namespace

Result<std::unique_ptr<Gui>> Gui::create(const Window& window) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // the layout is ours
    io.LogFilename = nullptr;
    dress(window.contentScale());
    std::unique_ptr<Gui> gui(new Gui);
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), /*install_callbacks=*/true);
    if (!ImGui_ImplOpenGL3_Init("#version 330 core")) {
        return AoStatus(StatusCode::ShaderError, "Dear ImGui cannot draw in this context");
    }
    return gui;
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Gui::beginFrame() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void Gui::endFrame() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

} // namespace aolib::viewer
