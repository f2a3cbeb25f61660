#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace aolib::app {

/// Rays per pixel where a truth is needed and none are said, and the most that may be.
inline constexpr int kDefaultRays = 256;
inline constexpr int kMostRays = 1 << 20;

/// Throws the parser's error: "FLAG TEXT: WANTED is needed".
[[noreturn]] void reject(const std::string& flag, const std::string& text,
                         const std::string& wanted);

// Each adds a flag to a command whose value is checked before `take` gets it. A value that does not
// fit is an error that names the flag, the value and what is needed.

/// A whole number between `min` and `max`.
CLI::Option* addWholeNumber(CLI::App& command, const std::string& flag, int min, int max,
                            const std::function<void(int)>& take, const std::string& help);
/// The same, into a variable that holds the default and must outlive the command.
CLI::Option* addWholeNumber(CLI::App& command, const std::string& flag, int min, int max,
                            int& value, const std::string& help);
/// A finite number.
CLI::Option* addNumber(CLI::App& command, const std::string& flag,
                       const std::function<void(double)>& take, const std::string& help);
/// "x,y,z". Repeating the flag calls `take` again.
CLI::Option* addVector(CLI::App& command, const std::string& flag,
                       const std::function<void(const glm::vec3&)>& take, const std::string& help);
/// Texts, one each time that the flag is given, into a variable that must outlive the command.
CLI::Option* addTexts(CLI::App& command, const std::string& flag, std::vector<std::string>& values,
                      const std::string& type, const std::string& help);
/// One of `names`; `take` gets its number.
CLI::Option* addNameOf(CLI::App& command, const std::string& flag,
                       const std::vector<std::string>& names,
                       const std::function<void(std::size_t)>& take, const std::string& help);
/// One of the names of `choices`.
template <typename Value>
CLI::Option* addChoice(CLI::App& command, const std::string& flag,
                       const std::vector<std::pair<std::string, Value>>& choices,
                       const std::function<void(Value)>& take, const std::string& help) {
    std::vector<std::string> names;
    for (const auto& [name, value] : choices) {
        names.push_back(name);
    }
    return addNameOf(
        command, flag, names, [=](std::size_t number) { take(choices[number].second); }, help);
}

} // namespace aolib::app
