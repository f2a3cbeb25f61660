#pragma once

#include "app/Failure.h"

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

/// Adds "thesis" to the command "bench": the figures of the thesis, measured here.
void addBenchThesis(CLI::App& bench, MaybeFailure& failure);

} // namespace aolib::app
