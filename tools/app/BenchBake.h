#pragma once

#include <CLI/CLI.hpp>

#include "app/Outcome.h"

namespace aolib::app {

/// Adds `aolib bench bake`: the bakers' time and error over meshes, methods and samples.
void addBenchBake(CLI::App& bench, MaybeFailure& failure);

} // namespace aolib::app
