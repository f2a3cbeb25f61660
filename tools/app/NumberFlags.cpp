#include "app/NumberFlags.h"

#include <cmath>
#include <optional>
#include <vector>

#include "app/ParseValues.h"

namespace aolib::app {

namespace {

[[noreturn]] void reject(const std::string& flag, const std::string& text,
                         const std::string& wanted) {
    throw CLI::ValidationError(flag + " " + text + ": " + wanted);
}

} // namespace

CLI::Option* addWholeNumber(CLI::App& command, const std::string& flag, int min, int max,
                            const std::function<void(int)>& take, const std::string& help) {
    const auto parse = [=](const std::string& text) {
        const std::optional<double> value = parseNumber(text);
        if (!value || !(*value >= min && *value <= max) || *value != std::floor(*value)) {
            reject(flag, text,
                   "a whole number between " + std::to_string(min) + " and " + std::to_string(max) +
                       " is needed");
        }
        take(static_cast<int>(*value));
    };
    return command.add_option_function<std::string>(flag, parse, help)->type_name("INT");
}

CLI::Option* addNumber(CLI::App& command, const std::string& flag,
                       const std::function<void(double)>& take, const std::string& help) {
    const auto parse = [=](const std::string& text) {
        const std::optional<double> value = parseNumber(text);
        if (!value) {
            reject(flag, text, "a finite number is needed");
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
                reject(flag, text, "three finite numbers x,y,z are needed");
            }
            take(*vector);
        }
    };
    return command.add_option_function<std::vector<std::string>>(flag, parse, help)
        ->type_name("X,Y,Z")
        ->allow_extra_args(false);
}

} // namespace aolib::app
