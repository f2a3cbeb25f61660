#include "app/CommandLineText.h"

#include <CLI/CLI.hpp>

namespace aolib::app {

namespace {

/// "aolib bench pareto"
std::string pathOf(const CLI::App& command) {
    const CLI::App* parent = command.get_parent();
    return parent == nullptr ? "aolib" : pathOf(*parent) + " " + command.get_name();
}

std::string quoted(const std::string& value) {
    return value.find_first_of(" *?'\"$&;()<>|") == std::string::npos ? value : "'" + value + "'";
}

} // namespace

std::string commandLineText(const CLI::App& command) {
    std::string line = pathOf(command);
    for (const CLI::Option* option : command.get_options()) {
        if (option->count() == 0) {
            continue;
        }
        if (option->get_items_expected_max() == 0) { // a switch
            line += " " + option->get_name();
            continue;
        }
        for (const std::string& value : option->results()) {
            line += " " + option->get_name() + " " + quoted(value);
        }
    }
    return line;
}

} // namespace aolib::app
