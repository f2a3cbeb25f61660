#include "viewer/FrameGraph.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <imgui.h>

namespace aolib::viewer {

namespace {

constexpr float kHeight = 90.0F; ///< pixels
/// Colours of passes, in the order of their first appearance.
constexpr std::array<ImU32, 10> kColours{
    IM_COL32(140, 140, 140, 255), IM_COL32(86, 180, 233, 255), IM_COL32(230, 159, 0, 255),
    IM_COL32(0, 158, 115, 255),   IM_COL32(240, 228, 66, 255), IM_COL32(213, 94, 0, 255),
    IM_COL32(204, 121, 167, 255), IM_COL32(0, 114, 178, 255),  IM_COL32(180, 220, 160, 255),
    IM_COL32(200, 160, 255, 255)};

ImU32 colourOf(const FrameTimes& times, const std::string& pass) {
    const auto& passes = times.passes();
    const auto place = std::ranges::find(passes, pass) - passes.begin();
    return kColours[static_cast<std::size_t>(place) % kColours.size()];
}

/// The end of the scale: 1, 2 or 5 times a power of ten.
double roundUp(double ms) {
    const double power = std::pow(10.0, std::floor(std::log10(std::max(ms, 0.1))));
    for (const double step : {1.0, 2.0, 5.0}) {
        if (ms <= step * power) {
            return step * power;
        }
    }
    return 10.0 * power;
}

void drawBars(const FrameTimes& times) {
    const ImVec2 origin = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, kHeight);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end(origin.x + size.x, origin.y + size.y);
    list.AddRectFilled(origin, end, IM_COL32(20, 20, 20, 255));
    const double scale = roundUp(times.longest());
    const float width = size.x / static_cast<float>(FrameTimes::kKept);
    float x = end.x - width * static_cast<float>(times.frames().size());
    for (const std::vector<bench::PassTime>& frame : times.frames()) {
        float y = end.y;
        for (const bench::PassTime& time : frame) {
            const float height = static_cast<float>(time.ms / scale) * size.y;
            list.AddRectFilled({x, y - height}, {x + width, y}, colourOf(times, time.pass));
            y -= height;
        }
        x += width;
    }
    char text[32];
    std::snprintf(text, sizeof text, "%g ms", scale);
    list.AddText({origin.x + 4.0F, origin.y + 2.0F}, IM_COL32(220, 220, 220, 255), text);
    ImGui::Dummy(size);
}

bool inAny(const FrameTimes& times, const std::string& pass) {
    return std::ranges::any_of(times.frames(), [&](const std::vector<bench::PassTime>& frame) {
        return std::ranges::any_of(frame,
                                   [&](const bench::PassTime& time) { return time.pass == pass; });
    });
}

void drawLegend(const FrameTimes& times) {
    const float column = 0.5F * ImGui::GetContentRegionAvail().x;
    const float left = ImGui::GetCursorPosX();
    const float size = ImGui::GetFontSize();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    bool second = false;
    for (const std::string& pass : times.passes()) {
        if (!inAny(times, pass)) {
            continue;
        }
        if (second) {
            ImGui::SameLine(left + column);
        }
        char text[96];
        std::snprintf(text, sizeof text, "%5.1f %s", times.median(pass), pass.c_str());
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImVec2 end(at.x + column - 0.5F * size, at.y + 1.3F * size);
        list.AddRectFilled({at.x, at.y + 0.2F * size}, {at.x + 0.6F * size, at.y + 0.8F * size},
                           colourOf(times, pass));
        list.PushClipRect(at, end, true);
        list.AddText({at.x + 0.9F * size, at.y}, ImGui::GetColorU32(ImGuiCol_Text), text);
        list.PopClipRect();
        ImGui::Dummy({column - 0.5F * size, size});
        if (ImGui::IsItemHovered()) {
            ImGui::SetTooltip("%s: %.2f ms, median", pass.c_str(), times.median(pass));
        }
        second = !second;
    }
}

} // namespace

void drawFrameGraph(const FrameTimes& times) {
    drawBars(times);
    drawLegend(times);
}

} // namespace aolib::viewer
