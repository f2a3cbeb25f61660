#pragma once

#include <functional>
#include <iostream>
#include <string>

#include "app/Failure.h"
#include "app/Progress.h"
#include "bench/Receivers.h"

namespace aolib::app {

/// What benches have in common: a folder for their results, and a bar on the way to them.

/// The most that --repeat may say, and the pictures of --quick.
inline constexpr int kMostRepeats = 100;
inline constexpr int kMostBuildSeconds = 100000;
inline constexpr bench::PictureSize kQuickSize{320, 180};

/// Makes the folder that --out names, if it is missing.
MaybeFailure makeOutFolder(const std::string& out);

/// Begins a part of the task, or tells how far it is, on a bar; false once Ctrl-C was pressed.
std::function<bool(const std::string& stage, double done)> stagesOn(Progress& progress);

/// Lets a run's reports (`stage`, `progress`, `warn`) show on a bar.
template <typename Reports>
void showOn(Progress& progress, Reports& reports) {
    reports.stage = [&progress](const std::string& stage) { progress.begin(stage); };
    reports.progress = [&progress](double fraction) { progress.update(fraction); };
    reports.warn = [&progress](const std::string& remark) {
        progress.pause();
        std::cerr << "aolib: warning: " << remark << '\n';
    };
}

} // namespace aolib::app
