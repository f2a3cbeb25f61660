#include "app/NumberFlags.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/ParseValues.h"

namespace aolib::app {

void reject(const std::string& flag, const std::string& text, const std::string& wanted) {
    throw CLI::ValidationError(flag + " " + text + ": " + wanted + " is needed");
}

CLI::Option* addWholeNumber(CLI::App& command, const std::string& flag, int min, int max,
                            const std::function<void(int)>& take, const std::string& help) {
    const auto parse = [=](const std::string& text) {
        const std::optional<double> value = parseNumber(text);
        if (!value || !(*value >= min && *value <= max) || *value != std::floor(*value)) {
            reject(flag, text,
                   "a whole number between " + std::to_string(min) + " and " + std::to_string(max));
        }
        take(static_cast<int>(*value));
    };
    return command.add_option_function<std::string>(flag, parse, help)->type_name("INT");
}

CLI::Option* addWholeNumber(CLI::App& command, const std::string& flag, int min, int max,
                            int& value, const std::string& help) {
    const auto take = [&value](int number) { value = number; };
    return addWholeNumber(command, flag, min, max, take, help)->default_str(std::to_string(value));
}

CLI::Option* addNumber(CLI::App& command, const std::string& flag,
                       const std::function<void(double)>& take, const std::string& help) {
    const auto parse = [=](const std::string& text) {
        const std::optional<double> value = parseNumber(text);
        if (!value) {
            reject(flag, text, "a finite number");
        }
        take(*value);
    };
    return command.add_option_function<std::string>(flag, parse, help)->type_name("NUMBER");
}

CLI::Option* addVector(CLI::App& command, const std::string& flag,
                       const std::function<void(const glm::vec3&)>& take, const std::string& help) {
    const auto parse = [=](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) {
            const std::optional<glm::vec3> vector = parseVector(text);
            if (!vector) {
                throw CLI::ValidationError(flag + " " + text +
                                           ": three finite numbers x,y,z are needed");
            }
            take(*vector);
        }
    };
    return command.add_option_function<std::vector<std::string>>(flag, parse, help)
        ->type_name("X,Y,Z")
        ->allow_extra_args(false);
}

CLI::Option* addTexts(CLI::App& command, const std::string& flag, std::vector<std::string>& values,
                      const std::string& type, const std::string& help) {
    return command.add_option(flag, values, help)->type_name(type)->allow_extra_args(false);
}

CLI::Option* addNameOf(CLI::App& command, const std::string& flag,
                       const std::vector<std::string>& names,
                       const std::function<void(std::size_t)>& take, const std::string& help) {
    std::string all;
    for (const std::string& name : names) {
        all += (all.empty() ? "" : "|") + name;
    }
    const auto parse = [=](const std::string& text) {
        const auto found = std::find(names.begin(), names.end(), text);
        if (found == names.end()) {
            reject(flag, text, "one of " + all);
        }
        take(static_cast<std::size_t>(found - names.begin()));
    };
    return command.add_option_function<std::string>(flag, parse, help)->type_name(all);
}

} // namespace aolib::app
