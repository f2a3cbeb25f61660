#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <aolib/ProcAddressLoader.h>

#include "bench/CaseTable.h"
#include "bench/MachineInfo.h"
#include "bench/Measurement.h"
#include "bench/Receivers.h"
#include "bench/ThesisTable.h"
#include "content/LoadError.h"
#include "gl/Functions.h"

namespace aolib::bench {

/// What to measure: every setting in every scene, its first camera, radius 10%.
struct ThesisRunSettings {
    std::vector<BenchScene> scenes;
    std::vector<ThesisSetting> settings;
    PictureSize size;
    TimingSettings timing;
    std::filesystem::path out; ///< an existing folder
    MachineInfo machine;
    std::string commandLine;
};

/// A setting in a scene.
struct ThesisRow {
    std::string scene;
    std::size_t triangles = 0;
    ThesisSetting setting;
    std::string failure;          ///< why there are no figures; empty when all went well
    Spread buildMs;               ///< of one cube map: all builds, divided by the cube maps
    Spread frameMs;               ///< what the library adds to a frame once all is built
    int layers = 0;               ///< of intervals captured, the most among the cube maps
    std::size_t bytesKept = 0;    ///< GPU memory of one cube map, mean
    std::size_t bytesCapture = 0; ///< GPU memory that a build took and gave back, the most
};

/// What whoever started the run hears of it.
struct ThesisReports {
    std::function<void(const std::string& stage)> stage;
    std::function<void(double fraction)> progress; ///< of the whole run
    std::function<void(const std::string& remark)> warn;
    /// A scene is done; what was gathered so far. A text is the reason to stop.
    std::function<std::string(const std::vector<ThesisRow>& rows)> sceneDone;
};

/// Errors: nothing could be measured; what sceneDone answers.
Result<std::vector<ThesisRow>, LoadError> runThesis(const gl::Functions& gl,
                                                    const ProcAddressLoader& loader,
                                                    const ThesisRunSettings& settings,
                                                    const ThesisReports& reports);

} // namespace aolib::bench
