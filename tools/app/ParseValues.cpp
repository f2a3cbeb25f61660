#include "app/ParseValues.h"

#include <charconv>
#include <cmath>
#include <limits>

namespace aolib::app {

std::optional<double> parseNumber(const std::string& text) {
    double value = 0.0;
    const char* first = text.data();
    const char* last = first + text.size();
    if (last - first > 1 && first[0] == '+' && first[1] != '-') {
        ++first;
    }
    const auto [end, error] = std::from_chars(first, last, value);
    if (error != std::errc() || end != last || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

std::optional<glm::vec3> parseVector(const std::string& text) {
    glm::vec3 vector{0.0F};
    std::size_t begin = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t comma = text.find(',', begin);
        if ((comma == std::string::npos) != (axis == 2)) {
            return std::nullopt;
        }
        const std::optional<double> value = parseNumber(text.substr(begin, comma - begin));
        if (!value || std::abs(*value) > static_cast<double>(std::numeric_limits<float>::max())) {
            return std::nullopt;
        }
        vector[axis] = static_cast<float>(*value);
        begin = comma + 1;
    }
    return vector;
}

std::optional<Length> parseLength(const std::string& text) {
    const bool relative = !text.empty() && text.back() == '%';
    const std::optional<double> value =
        parseNumber(relative ? text.substr(0, text.size() - 1) : text);
    if (!value || *value < 0.0) {
        return std::nullopt;
    }
    return Length{relative ? *value / 100.0 : *value, relative};
}

} // namespace aolib::app
