#include "app/OptionFlags.h"

#include <limits>
#include <map>
#include <sstream>
#include <string_view>
#include <type_traits>

#include <CLI/CLI.hpp>
#include <aolib/OptionFields.h>

#include "app/NumberFlags.h"

namespace aolib::app {

namespace {

const char* const kOptionsGroup = "Ambient occlusion";

/// Names that options had before, which are taken still.
const std::map<std::string_view, std::string> kFormerNames{{"refine-static-views", "repair"},
                                                           {"screen-space-fallback", "fallback"}};

std::string compact(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

/// "in [16, 4096]", or "at least 0" where there is no upper end worth naming.
std::string describe(const OptionRange& range) {
    constexpr double kUnbounded = std::numeric_limits<float>::max();
    return range.max >= kUnbounded ? "at least " + compact(range.min)
                                   : "between " + compact(range.min) + " and " + compact(range.max);
}

/// Adds one flag for each field that visitOptions() shows it.
class FlagMaker {
public:
    using Take = std::function<void(const std::string& name, std::variant<double, Length> value)>;

    FlagMaker(CLI::App& command, Take take) : command_(command), take_(std::move(take)) {}

    template <typename Number>
    void operator()(std::string_view name, Number& field, OptionRange range,
                    std::string_view help) const {
        if (name == "radius") {
            addLength(std::string(name), std::string(help) + "; 5% = that share of the diagonal");
            return;
        }
        const std::string flag = "--" + std::string(name);
        const auto parse = [flag, range, take = take_,
                            key = std::string(name)](const std::string& text) {
            const std::optional<double> value = parseNumber(text);
            if (!value || !(*value >= range.min && *value <= range.max)) {
                reject(flag, text, "a number " + describe(range));
            }
            if (std::is_integral_v<Number> &&
                *value != static_cast<double>(static_cast<long long>(*value))) {
                reject(flag, text, "a whole number");
            }
            take(key, *value);
        };
        command_.add_option_function<std::string>(flag, parse, std::string(help))
            ->type_name(std::is_integral_v<Number> ? "INT" : "NUMBER")
            ->default_str(compact(static_cast<double>(field)))
            ->group(kOptionsGroup);
    }

    void operator()(std::string_view name, bool& field, std::string_view help) const {
        const std::string key(name);
        const auto set = [take = take_, key](std::int64_t) { take(key, 1.0); };
        const auto clear = [take = take_, key](std::int64_t) { take(key, 0.0); };
        command_
            .add_flag_function("--" + key, set,
                               std::string(help) +
                                   (field ? "; on unless --no-" + key : std::string()))
            ->group(kOptionsGroup);
        command_.add_flag_function("--no-" + key, clear, "")->group("");
        if (const auto former = kFormerNames.find(name); former != kFormerNames.end()) {
            command_.add_flag_function("--" + former->second, set, "")->group("");
            command_.add_flag_function("--no-" + former->second, clear, "")->group("");
        }
    }

    template <typename E, std::size_t N>
    void operator()(std::string_view name, E& field, const std::array<OptionChoice<E>, N>& choices,
                    std::string_view help) const {
        std::vector<std::pair<std::string, E>> named;
        std::string chosen;
        for (const OptionChoice<E>& choice : choices) {
            named.emplace_back(choice.name, choice.value);
            chosen = choice.value == field ? std::string(choice.name) : chosen;
        }
        addChoice<E>(
            command_, "--" + std::string(name), named,
            [take = take_, key = std::string(name)](E value) {
                take(key, static_cast<double>(value));
            },
            std::string(help))
            ->default_str(chosen)
            ->group(kOptionsGroup);
    }

private:
    void addLength(const std::string& name, const std::string& help) const {
        const std::string flag = "--" + name;
        const auto parse = [flag, name, take = take_](const std::string& text) {
            const std::optional<Length> length = parseLength(text);
            if (!length) {
                reject(flag, text, "a number of at least 0, or a percentage such as 10%,");
            }
            take(name, *length);
        };
        command_.add_option_function<std::string>(flag, parse, help)
            ->type_name("LENGTH")
            ->group(kOptionsGroup);
    }

    CLI::App& command_;
    Take take_;
};

} // namespace

void OptionFlags::attach(CLI::App& command, const std::set<std::string>& only) {
    const FlagMaker maker(command,
                          [this](const std::string& name, Value value) { values_[name] = value; });
    Options defaults;
    visitOptions(defaults, [&](std::string_view name, auto& field, const auto&... rest) {
        if (only.empty() || only.count(std::string(name)) != 0) {
            maker(name, field, rest...);
        }
    });
}

void OptionFlags::apply(Options& options, double diagonal) const {
    const auto value = [&](std::string_view name) -> std::optional<double> {
        const auto found = values_.find(std::string(name));
        if (found == values_.end()) {
            return std::nullopt;
        }
        const auto* length = std::get_if<Length>(&found->second);
        return length != nullptr ? length->resolved(diagonal) : std::get<double>(found->second);
    };
    visitOptions(options, [&](std::string_view name, auto& field, const auto&...) {
        if (const std::optional<double> given = value(name)) {
            field = static_cast<std::decay_t<decltype(field)>>(
                static_cast<
                    std::conditional_t<std::is_enum_v<std::decay_t<decltype(field)>>, int, double>>(
                    *given));
        }
    });
}

std::vector<std::string> OptionFlags::given() const {
    std::vector<std::string> names;
    for (const auto& [name, value] : values_) {
        names.push_back(name);
    }
    return names;
}

} // namespace aolib::app
