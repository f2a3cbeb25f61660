#pragma once

#include "app/Failure.h"

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

/// Adds `aolib bench environment`: error and time of environment lighting.
void addBenchEnvironment(CLI::App& bench, MaybeFailure& failure);

} // namespace aolib::app
