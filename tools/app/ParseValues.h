#pragma once

#include <optional>
#include <string>

#include <glm/vec3.hpp>

namespace aolib::app {

/// A finite number and nothing else: "1.5", "-2e3". Nothing when it is none.
std::optional<double> parseNumber(const std::string& text);

/// "x,y,z", three finite numbers within the range of float. Nothing when it is none.
std::optional<glm::vec3> parseVector(const std::string& text);

/// A length, absolute ("0.3") or as a share of the scene's diagonal ("10%").
struct Length {
    double value = 0.0;    ///< world units, or the share: 0.1 for "10%"
    bool relative = false; ///< a share of the diagonal

    double resolved(double diagonal) const { return relative ? value * diagonal : value; }
};

/// "0.3" or "10%", at least 0. Nothing when it is none.
std::optional<Length> parseLength(const std::string& text);

} // namespace aolib::app
