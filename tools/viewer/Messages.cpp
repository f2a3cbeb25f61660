#include "viewer/Messages.h"

#include <algorithm>
#include <utility>

#include <imgui.h>

namespace aolib::viewer {

namespace {

constexpr std::chrono::seconds kShown{6};
constexpr std::chrono::seconds kWarningShown{15};
constexpr std::size_t kMost = 4;
constexpr float kMessageMargin = 12.0F; ///< pixels from the picture's edges
constexpr float kMessageOpacity = 0.85F;
const ImVec4 kWarningColour{1.0F, 0.6F, 0.45F, 1.0F};
const ImVec4 kTextColour{1.0F, 1.0F, 1.0F, 1.0F};

} // namespace

void Messages::add(std::string sentence, bool warning) {
    latest_ = sentence;
    // Said again, it only stays longer.
    std::erase_if(messages_, [&](const Message& m) { return m.sentence == sentence; });
    messages_.push_back(
        {std::move(sentence), warning, Clock::now() + (warning ? kWarningShown : kShown)});
    if (messages_.size() > kMost) {
        messages_.pop_front();
    }
}

double Messages::secondsLeft() const {
    if (messages_.empty()) {
        return -1.0;
    }
    const auto next = std::ranges::min_element(messages_, {}, &Message::until);
    return std::max(std::chrono::duration<double>(next->until - Clock::now()).count(), 0.0);
}

void Messages::draw(const glm::vec2& size) {
    std::erase_if(messages_, [](const Message& m) { return m.until <= Clock::now(); });
    if (messages_.empty()) {
        return;
    }
    ImGui::SetNextWindowPos({kMessageMargin, size.y - kMessageMargin}, ImGuiCond_Always,
                            {0.0F, 1.0F});
    ImGui::SetNextWindowBgAlpha(kMessageOpacity);
    ImGui::Begin("##messages", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav);
    ImGui::PushTextWrapPos(std::max(size.x - 3.0F * kMessageMargin, 100.0F));
    for (const Message& message : messages_) {
        ImGui::PushStyleColor(ImGuiCol_Text, message.warning ? kWarningColour : kTextColour);
        ImGui::TextUnformatted(message.sentence.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::PopTextWrapPos();
    ImGui::End();
}

} // namespace aolib::viewer
