#pragma once

#include <CLI/CLI.hpp>

#include "app/Outcome.h"

namespace aolib::app {

/// Adds `aolib bench poses`: error of visibility blended between baked poses.
void addBenchPoses(CLI::App& bench, MaybeFailure& failure);

} // namespace aolib::app
