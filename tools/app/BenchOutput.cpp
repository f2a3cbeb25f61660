#include "app/BenchOutput.h"

#include <filesystem>
#include <system_error>

#include "app/Interruption.h"

namespace aolib::app {

MaybeFailure makeOutFolder(const std::string& out) {
    std::error_code error;
    std::filesystem::create_directories(out, error);
    if (error) {
        return badInput("--out " + out + ": cannot be made: " + error.message());
    }
    return std::nullopt;
}

std::function<bool(const std::string&, double)> stagesOn(Progress& progress) {
    return [&progress](const std::string& stage, double done) {
        progress.begin(stage);
        progress.update(done);
        return !Interruption::happened();
    };
}

} // namespace aolib::app
