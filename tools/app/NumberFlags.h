#pragma once

#include <functional>
#include <string>

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

} // namespace aolib::app
