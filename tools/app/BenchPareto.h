#pragma once

#include "app/Failure.h"

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

/// Adds "pareto" to the command "bench": error against cost, every method over every case.
void addBenchPareto(CLI::App& bench, MaybeFailure& failure);

} // namespace aolib::app
