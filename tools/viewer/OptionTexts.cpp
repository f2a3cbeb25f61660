#include "viewer/OptionTexts.h"

#include <array>
#include <charconv>
#include <type_traits>

namespace aolib::viewer {

namespace {

/// Shortest digits that give the same number again.
template <typename Number>
std::string digits(Number value) {
    std::array<char, 48> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

struct Speller {
    std::vector<OptionText> texts;

    template <typename Number>
    void operator()(std::string_view name, const Number& value, OptionRange, std::string_view) {
        texts.push_back({std::string(name), digits(value)});
    }
    void operator()(std::string_view name, const bool& value, std::string_view) {
        texts.push_back({std::string(name), value ? "on" : "off"});
    }
    template <typename E, std::size_t N>
    void operator()(std::string_view name, const E& value,
                    const std::array<OptionChoice<E>, N>& choices, std::string_view) {
        for (const OptionChoice<E>& choice : choices) {
            if (choice.value == value) {
                texts.push_back({std::string(name), std::string(choice.name)});
            }
        }
    }
};

std::string flagOf(const OptionText& text) {
    if (text.value == "on") {
        return "--" + text.name;
    }
    return text.value == "off" ? "--no-" + text.name : "--" + text.name + " " + text.value;
}

} // namespace

std::vector<OptionText> optionTexts(const Options& options) {
    Speller speller;
    visitOptions(options, speller);
    return speller.texts;
}

std::string optionFlags(const Options& options, const Options& from) {
    const std::vector<OptionText> now = optionTexts(options);
    const std::vector<OptionText> before = optionTexts(from);
    std::string flags;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (!(now[i] == before[i])) {
            flags += (flags.empty() ? "" : " ") + flagOf(now[i]);
        }
    }
    return flags;
}

} // namespace aolib::viewer
