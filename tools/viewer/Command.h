#pragma once

#include <cstdint>
#include <span>

#include "viewer/Input.h"

namespace aolib::viewer {

/// What a key or a button makes the viewer do.
enum class Command : std::uint8_t {
    Help,
    Panel,
    Mode,
    ResetCamera,
    NextCamera,
    Occlusion,
    NextComparedMethod,
    NextDebugView,
    NextBackbone,
    NextEstimator,
    Gizmos,
    PlaceCubeMap,
    RemoveCubeMap,
    ClearCubeMaps,
    Screenshot,
    ExportCase,
    Quit,
};

/// A key that gives a command.
struct KeyBinding {
    int key;      ///< GLFW's number
    bool control; ///< with Control
    Command command;
    const char* name; ///< as the help shows it: "F1"
    const char* help; ///< what it does
};

/// Every key, in the order of the help.
std::span<const KeyBinding> keyBindings();

/// The command of a key that went down, or null.
const KeyBinding* bindingOf(const KeyPress& press);
/// The key of a command.
const KeyBinding& bindingOf(Command command);

} // namespace aolib::viewer
