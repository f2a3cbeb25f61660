#pragma once

#include "app/Failure.h"

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

/// Adds `aolib bench poses`: error of visibility blended between baked poses.
void addBenchPoses(CLI::App& bench, MaybeFailure& failure);

} // namespace aolib::app
