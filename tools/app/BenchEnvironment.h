#pragma once

#include <CLI/CLI.hpp>

#include "app/Outcome.h"

namespace aolib::app {

/// Adds `aolib bench environment`: error and time of environment lighting.
void addBenchEnvironment(CLI::App& bench, MaybeFailure& failure);

} // namespace aolib::app
