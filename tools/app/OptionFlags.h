#pragma once

#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <aolib/Options.h>

#include "app/ParseValues.h"

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

/// Every option of the library as a flag of its own name, made from visitOptions(). Only flags that
/// were given change anything, so that they can override a case file.
class OptionFlags {
public:
    /// Adds the flags to a command: all, or only those named. The object must outlive it.
    void attach(CLI::App& command, const std::set<std::string>& only = {});

    /// Writes the values given into `options`.
    /// @param diagonal  of the scene's bounding box, world units: what `--radius 10%` refers to.
    void apply(Options& options, double diagonal) const;

    bool given(const std::string& name) const { return values_.count(name) != 0; }
    /// All that were given, sorted.
    std::vector<std::string> given() const;

private:
    /// A number, a switch (0 or 1) or an enumerator, as visitOptions() will take it; or a length.
    using Value = std::variant<double, Length>;
    std::map<std::string, Value> values_;
};

} // namespace aolib::app
