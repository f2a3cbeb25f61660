#pragma once

#include <map>
#include <string>
#include <string_view>

#include <aolib/Options.h>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace aolib::viewer {

/// A slider, a switch or a list for each option of the library, made from visitOptions().
class OptionsPanel {
public:
    /// Draws them into the window that ImGui is in.
    /// @param defaults   what a click with the right button puts back.
    /// @param sceneSize  the scene's diagonal: where sliders of lengths end.
    /// Returns whether an option was changed.
    bool draw(Options& options, const Options& defaults, float sceneSize);

    /// Where each option was drawn, by name: x, y, width and height, mouse pixels.
    const std::map<std::string, glm::vec4, std::less<>>& places() const { return places_; }

private:
    std::map<std::string, glm::vec4, std::less<>> places_;
};

/// Whether an option has a meaning for an estimator: help texts begin with those that they are for.
bool appliesTo(std::string_view help, Estimator estimator);

} // namespace aolib::viewer
