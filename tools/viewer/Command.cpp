#include "viewer/Command.h"

#include <algorithm>
#include <array>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace aolib::viewer {

namespace {

constexpr std::array kBindings{
    KeyBinding{GLFW_KEY_F1, false, Command::Help, "F1", "show or hide this help"},
    KeyBinding{GLFW_KEY_TAB, false, Command::Panel, "Tab", "show or hide the panel"},
    KeyBinding{GLFW_KEY_F, false, Command::Mode, "F", "orbit or walk"},
    KeyBinding{GLFW_KEY_R, false, Command::ResetCamera, "R", "camera back to where it began"},
    KeyBinding{GLFW_KEY_N, false, Command::NextCamera, "N", "next camera of the scene"},
    KeyBinding{GLFW_KEY_O, false, Command::Occlusion, "O", "ambient occlusion on or off"},
    KeyBinding{GLFW_KEY_C, false, Command::NextComparedMethod, "C", "compare with the next"},
    KeyBinding{GLFW_KEY_V, false, Command::NextDebugView, "V", "next debug view"},
    KeyBinding{GLFW_KEY_B, false, Command::NextBackbone, "B", "next backbone"},
    KeyBinding{GLFW_KEY_T, false, Command::NextEstimator, "T", "next estimator"},
    KeyBinding{GLFW_KEY_G, false, Command::Gizmos, "G", "mark the cube maps"},
    KeyBinding{GLFW_KEY_M, false, Command::PlaceCubeMap, "M", "place a cube map at the camera"},
    KeyBinding{GLFW_KEY_DELETE, false, Command::RemoveCubeMap, "Delete",
               "remove the chosen cube map"},
    KeyBinding{GLFW_KEY_BACKSPACE, false, Command::ClearCubeMaps, "Backspace",
               "remove all cube maps"},
    KeyBinding{GLFW_KEY_F12, false, Command::Screenshot, "F12", "save what the window shows"},
    KeyBinding{GLFW_KEY_F11, false, Command::ExportCase, "F11", "save the view as a case file"},
    KeyBinding{GLFW_KEY_Q, true, Command::Quit, "Ctrl+Q", "quit"}};

} // namespace

std::span<const KeyBinding> keyBindings() {
    return kBindings;
}

const KeyBinding* bindingOf(const KeyPress& press) {
    const auto found = std::ranges::find_if(kBindings, [&](const KeyBinding& binding) {
        return binding.key == press.key && binding.control == press.control;
    });
    return found == kBindings.end() ? nullptr : &*found;
}

const KeyBinding& bindingOf(Command command) {
    return *std::ranges::find(kBindings, command, &KeyBinding::command);
}

} // namespace aolib::viewer
