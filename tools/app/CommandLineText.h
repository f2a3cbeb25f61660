#pragma once

#include <string>

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

/// What a command was called with: to be kept beside results. Only once the line has been parsed.
std::string commandLineText(const CLI::App& command);

} // namespace aolib::app
