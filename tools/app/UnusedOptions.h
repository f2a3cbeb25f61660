#pragma once

#include <string>
#include <vector>

#include <aolib/Options.h>

#include "app/BakeFlags.h"
#include "app/OptionFlags.h"

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

/// A sentence for each flag that was given and that nothing reads.
/// @param options  those in force, estimator and all.
std::vector<std::string> unusedOptions(const OptionFlags& given, const Options& options);

/// The same of "aolib bake". @param command  after it was parsed.
std::vector<std::string> unusedBakeFlags(const CLI::App& command, const BakeFlags& flags);

/// Prints them as warnings, to standard error.
void warnOf(const std::vector<std::string>& sentences);

} // namespace aolib::app
