#include "viewer/OptionsPanel.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <aolib/OptionFields.h>
#include <imgui.h>

#include "viewer/OptionTexts.h"

namespace aolib::viewer {

namespace {

constexpr double kUnbounded = std::numeric_limits<float>::max();
/// Ranges whose ends are so far apart get a slider whose steps grow with the value.
constexpr double kWide = 100.0;
constexpr float kFaint = 0.45F;
constexpr float kLabelShare = 0.42F; ///< of the panel's width
const ImVec4 kChangedColour{1.0F, 0.82F, 0.45F, 1.0F};

ImGuiSliderFlags flagsFor(double min, double max) {
    const ImGuiSliderFlags clamp = ImGuiSliderFlags_AlwaysClamp;
    return max - min > kWide ? clamp | ImGuiSliderFlags_Logarithmic : clamp;
}

/// Draws one widget for each field that visitOptions() shows it.
struct WidgetMaker {
    Estimator estimator;
    float sceneSize;
    std::map<std::string, glm::vec4, std::less<>>& places;
    std::vector<OptionText> texts;    ///< of the options as they are
    std::vector<OptionText> defaults; ///< as they were
    std::size_t next = 0;
    bool changed = false;
    std::string restore; ///< the option to be put back

    void operator()(std::string_view name, float& value, OptionRange range, std::string_view help) {
        begin(name, help);
        const auto low = static_cast<float>(range.min);
        const bool length = range.max >= kUnbounded;
        const float high = length ? std::max(sceneSize, value) : static_cast<float>(range.max);
        const ImGuiSliderFlags flags =
            length ? ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp
                   : flagsFor(range.min, range.max);
        const bool edited = ImGui::SliderFloat("##value", &value, low, high, "%.4g", flags);
        end(name, help, edited);
    }
    void operator()(std::string_view name, int& value, OptionRange range, std::string_view help) {
        begin(name, help);
        const bool edited =
            ImGui::SliderInt("##value", &value, static_cast<int>(range.min),
                             static_cast<int>(range.max), "%d", flagsFor(range.min, range.max));
        if (edited && help.ends_with(", odd")) {
            value |= 1;
        }
        end(name, help, edited);
    }
    void operator()(std::string_view name, bool& value, std::string_view help) {
        begin(name, help);
        const bool edited = ImGui::Checkbox("##value", &value);
        end(name, help, edited);
    }
    template <typename E, std::size_t N>
    void operator()(std::string_view name, E& value, const std::array<OptionChoice<E>, N>& choices,
                    std::string_view help) {
        begin(name, help);
        bool edited = false;
        if (ImGui::BeginCombo("##value", texts[next].value.c_str())) {
            for (const OptionChoice<E>& choice : choices) {
                const bool chosen = choice.value == value;
                if (ImGui::Selectable(std::string(choice.name).c_str(), chosen) && !chosen) {
                    value = choice.value;
                    edited = true;
                }
            }
            ImGui::EndCombo();
        }
        end(name, help, edited);
    }

private:
    void begin(std::string_view name, std::string_view help) {
        ImGui::PushID(static_cast<int>(next));
        if (!appliesTo(help, estimator)) {
            ImGui::PushStyleVar(ImGuiStyleVar_Alpha, kFaint);
        } else {
            ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1.0F);
        }
        const bool asBefore = texts[next] == defaults[next];
        ImGui::AlignTextToFramePadding();
        if (asBefore) {
            ImGui::TextUnformatted(name.data(), name.data() + name.size());
        } else {
            ImGui::TextColored(kChangedColour, "%s", std::string(name).c_str());
        }
        explain(help);
        ImGui::SameLine(kLabelShare * ImGui::GetWindowWidth());
        ImGui::SetNextItemWidth(-1.0F);
    }

    void end(std::string_view name, std::string_view help, bool edited) {
        const ImVec2 low = ImGui::GetItemRectMin();
        const ImVec2 size = ImGui::GetItemRectSize();
        places[std::string(name)] = {low.x, low.y, size.x, size.y};
        explain(help);
        if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
            restore = name;
        }
        changed = changed || edited;
        ImGui::PopStyleVar();
        ImGui::PopID();
        ++next;
    }

    void explain(std::string_view help) const {
        if (ImGui::IsItemHovered()) {
            ImGui::BeginTooltip();
            ImGui::PushTextWrapPos(26.0F * ImGui::GetFontSize());
            ImGui::TextUnformatted(help.data(), help.data() + help.size());
            ImGui::TextDisabled("here %s at first: a right click puts it back; Ctrl and a click on "
                                "a slider: type the value",
                                defaults[next].value.c_str());
            ImGui::PopTextWrapPos();
            ImGui::EndTooltip();
        }
    }
};

/// Takes one option from another set.
void takeOne(Options& options, const Options& from, const std::string& name) {
    std::vector<const void*> fields;
    visitOptions(from, [&](std::string_view, const auto& field, const auto&...) {
        fields.push_back(&field);
    });
    std::size_t next = 0;
    visitOptions(options, [&](std::string_view which, auto& field, const auto&...) {
        const void* source = fields[next++]; // the same field: both are visited in one order
        if (which == name) {
            field = *static_cast<const std::decay_t<decltype(field)>*>(source);
        }
    });
}

} // namespace

bool appliesTo(std::string_view help, Estimator estimator) {
    const std::size_t colon = help.find(": ");
    if (colon == std::string_view::npos) {
        return true;
    }
    const std::string_view meant = help.substr(0, colon);
    bool namesOne = false;
    for (const OptionChoice<Estimator>& choice : kEstimatorChoices) {
        if (meant.find(choice.name) != std::string_view::npos) {
            namesOne = true;
            if (choice.value == estimator) {
                return true;
            }
        }
    }
    return !namesOne;
}

bool OptionsPanel::draw(Options& options, const Options& defaults, float sceneSize) {
    places_.clear();
    WidgetMaker maker{.estimator = options.estimator,
                      .sceneSize = sceneSize,
                      .places = places_,
                      .texts = optionTexts(options),
                      .defaults = optionTexts(defaults),
                      .restore = {}};
    visitOptions(options, maker);
    if (!maker.restore.empty()) {
        takeOne(options, defaults, maker.restore);
    }
    return maker.changed || !maker.restore.empty();
}

} // namespace aolib::viewer
