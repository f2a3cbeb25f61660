#pragma once

#include "viewer/FrameTimes.h"

namespace aolib::viewer {

/// Draws the times of the latest frames as stacked bars, a colour for each pass, and their medians
/// below, into the window that ImGui is in.
void drawFrameGraph(const FrameTimes& times);

} // namespace aolib::viewer
