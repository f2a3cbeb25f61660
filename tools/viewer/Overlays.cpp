#include "viewer/Overlays.h"

#include <array>

#include <imgui.h>

namespace aolib::viewer {

namespace {

constexpr float kMargin = 10.0F;
constexpr float kHandle = 12.0F; ///< half of its height, pixels
constexpr float kOpacity = 0.94F;
constexpr float kHelpWidth = 41.0F; ///< of its rows, font sizes
constexpr ImU32 kDark = IM_COL32(0, 0, 0, 150);

struct MouseRow {
    const char* what;
    const char* help;
};
constexpr std::array kMouse{
    MouseRow{"left drag", "orbit: turn the scene; walk: look around"},
    MouseRow{"right drag", "orbit: move the scene; walk: look around"},
    MouseRow{"wheel", "orbit: nearer or farther; walk: slower or faster"},
    MouseRow{"W A S D, Q E", "walk: ahead, left, back, right, down, up; Shift: faster"},
    MouseRow{"drag the line", "move the split"},
    MouseRow{"click a mark", "choose a cube map"},
    MouseRow{"drag a mark", "move its cube map; with Shift nearer or farther; Esc: not"},
    MouseRow{"drop a file", "open a .glb, .gltf, .obj, or a case (.json)"}};

void row(const char* left, const char* right) {
    ImGui::TextColored({1.0F, 0.82F, 0.45F, 1.0F}, "%s", left);
    ImGui::SameLine(9.5F * ImGui::GetFontSize());
    ImGui::TextUnformatted(right);
}

/// A text on a dark ground.
void label(ImDrawList& list, const ImVec2& at, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list.AddRectFilled({at.x - 5.0F, at.y - 3.0F}, {at.x + size.x + 5.0F, at.y + size.y + 3.0F},
                       kDark, 3.0F);
    list.AddText(at, IM_COL32_WHITE, text.c_str());
}

} // namespace

void drawHelp(const glm::vec2& picture, const glm::vec2& window) {
    const bool narrow = picture.x < kHelpWidth * ImGui::GetFontSize();
    const glm::vec2 middle = 0.5F * (narrow ? window : picture);
    ImGui::SetNextWindowPos({middle.x, middle.y}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {window.x, window.y}); // and scroll
    ImGui::SetNextWindowBgAlpha(kOpacity);
    ImGui::Begin("Keys and mouse", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    for (const MouseRow& mouse : kMouse) {
        row(mouse.what, mouse.help);
    }
    ImGui::Separator();
    for (const KeyBinding& binding : keyBindings()) {
        row(binding.name, binding.help);
    }
    ImGui::End();
}

void drawSplit(const SplitLine& split, const glm::vec2& size, const std::string& left,
               const std::string& right) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float x = split.share() * size.x;
    list.PushClipRect({0.0F, 0.0F}, {size.x, size.y});
    list.AddLine({x, 0.0F}, {x, size.y}, kDark, 4.0F);
    list.AddLine({x, 0.0F}, {x, size.y}, IM_COL32_WHITE, 1.5F);
    const float y = 0.5F * size.y;
    list.AddRectFilled({x - 4.0F, y - kHandle}, {x + 4.0F, y + kHandle}, IM_COL32_WHITE, 3.0F);
    list.PopClipRect();
    list.PushClipRect({0.0F, 0.0F}, {x, size.y});
    const float width = ImGui::CalcTextSize(left.c_str()).x;
    label(list, {x - width - 2.0F * kMargin, kMargin}, left);
    list.PopClipRect();
    list.PushClipRect({x, 0.0F}, {size.x, size.y});
    label(list, {x + 2.0F * kMargin, kMargin}, right);
    list.PopClipRect();
}

} // namespace aolib::viewer
