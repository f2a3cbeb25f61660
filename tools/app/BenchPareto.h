#pragma once

#include <CLI/CLI.hpp>

#include "app/Outcome.h"

namespace aolib::app {

/// Adds "pareto" to the command "bench": error against cost, every method over every case.
void addBenchPareto(CLI::App& bench, MaybeFailure& failure);

} // namespace aolib::app
