#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <glm/vec3.hpp>

namespace aolib::app {

/// Rays per pixel where a truth is needed and none are said, and the most that may be.
inline constexpr int kDefaultRays = 256;
inline constexpr int kMostRays = 1 << 20;

// Each adds a flag to a command whose value is checked before `take` gets it. A value that does not
// fit is an error that names the flag, the value and what is needed.

/// A whole number between `min` and `max`.
CLI::Option* addWholeNumber(CLI::App& command, const std::string& flag, int min, int max,
                            const std::function<void(int)>& take, const std::string& help);
/// A finite number.
CLI::Option* addNumber(CLI::App& command, const std::string& flag,
                       const std::function<void(double)>& take, const std::string& help);
/// "x,y,z". Repeating the flag calls `take` again.
CLI::Option* addVector(CLI::App& command, const std::string& flag,
                       const std::function<void(const glm::vec3&)>& take, const std::string& help);
/// One of the names of `choices`.
template <typename Value>
CLI::Option* addChoice(CLI::App& command, const std::string& flag,
                       const std::vector<std::pair<std::string, Value>>& choices,
                       const std::function<void(Value)>& take, const std::string& help) {
    std::string names;
    for (const auto& [name, value] : choices) {
        names += (names.empty() ? "" : "|") + name;
    }
    const auto parse = [=](const std::string& text) {
        for (const auto& [name, value] : choices) {
            if (name == text) {
                take(value);
                return;
            }
        }
        throw CLI::ValidationError(flag + " " + text + ": one of " + names + " is needed");
    };
    return command.add_option_function<std::string>(flag, parse, help)->type_name(names);
}

} // namespace aolib::app
