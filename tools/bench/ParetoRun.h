#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <aolib/ProcAddressLoader.h>

#include "bench/CaseTable.h"
#include "bench/MachineInfo.h"
#include "bench/Measurement.h"
#include "bench/MethodTable.h"
#include "bench/Truth.h"
#include "gl/Functions.h"

namespace aolib::bench {

/// What to measure.
struct ParetoSettings {
    std::vector<BenchCase> cases; ///< cases of a scene in a row
    std::vector<Method> methods;
    TruthSettings truth;
    TimingSettings timing;
    std::filesystem::path out;   ///< an existing folder
    std::filesystem::path cache; ///< of truths; empty: none
    MachineInfo machine;
    std::string commandLine;
};

/// A method in a case.
struct ParetoRow {
    BenchCase which;
    std::string camera;
    Method method;
    double truthNoise = 0.0;
    std::size_t truthMoved = 0; ///< its receivers that follow the picture instead of their ray
    Measurement measured;
};

/// "bunny, front, 10%"
std::string caseName(const ParetoRow& row);
/// "bunny-front-10", for files.
std::string caseFileName(const ParetoRow& row);

/// What whoever started the run hears of it.
struct ParetoReports {
    std::function<void(const std::string& stage)> stage; ///< a part began: for a progress bar
    std::function<void(double fraction)> progress;       ///< of the whole run
    std::function<void(const std::string& remark)> warn; ///< something was left out, and why
    /// A case is done; what was gathered so far. A text is the reason to stop.
    std::function<std::string(const std::vector<ParetoRow>& rows)> caseDone;
};

/// Measures every method in every case. Scenes that cannot be opened are left out with a warning.
/// Errors: nothing could be measured; the cache or the output cannot be written.
Result<std::vector<ParetoRow>, LoadError> runPareto(const gl::Functions& gl,
                                                    const ProcAddressLoader& loader,
                                                    const ParetoSettings& settings,
                                                    const ParetoReports& reports);

} // namespace aolib::bench
