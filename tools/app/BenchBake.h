#pragma once

#include "app/Failure.h"

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

/// Adds `aolib bench bake`: the bakers' time and error over meshes, methods and samples.
void addBenchBake(CLI::App& bench, MaybeFailure& failure);

} // namespace aolib::app
