#pragma once

#include "app/Failure.h"

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

// Each adds one subcommand to the program. When the command line names it, it runs while the line
// is parsed, and leaves a failure in `failure`.
void addRenderCommand(CLI::App& program, MaybeFailure& failure);
void addCompareCommand(CLI::App& program, MaybeFailure& failure);
void addTruthCommand(CLI::App& program, MaybeFailure& failure);
void addScenesCommand(CLI::App& program, MaybeFailure& failure);
void addBenchCommand(CLI::App& program, MaybeFailure& failure);
void addBakeCommand(CLI::App& program, MaybeFailure& failure);
void addViewCommand(CLI::App& program, MaybeFailure& failure);
void addDemoCommand(CLI::App& program, MaybeFailure& failure);

} // namespace aolib::app
