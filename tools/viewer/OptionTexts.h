#pragma once

#include <string>
#include <vector>

#include <aolib/OptionFields.h>

namespace aolib::viewer {

/// An option's name and value, as the command line spells them: {"slices", "8"}, {"blur", "on"}.
struct OptionText {
    std::string name;
    std::string value;

    bool operator==(const OptionText&) const = default;
};

/// Every option, in the order of visitOptions(). Numbers are exact.
std::vector<OptionText> optionTexts(const Options& options);

/// The flags of "aolib render" that make `from` these options: "--slices 16 --no-blur".
std::string optionFlags(const Options& options, const Options& from);

} // namespace aolib::viewer
