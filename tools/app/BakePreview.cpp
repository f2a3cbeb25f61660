#include "app/BakePreview.h"

#include <system_error>

#include "app/BakedImage.h"
#include "app/OutputFiles.h"
#include "app/Table.h"

namespace aolib::app {

namespace {

using namespace std::chrono_literals;

/// Between two pictures; longer where they take longer to make than a tenth of that.
constexpr auto kInterval = 2s;
constexpr int kMostShare = 10;

} // namespace

BakePreview::~BakePreview() {
    for (const std::filesystem::path& file : files_) {
        if (!kept_) {
            std::error_code ignored;
            std::filesystem::remove(file, ignored);
        }
    }
}

MaybeFailure BakePreview::write(const std::vector<bake::BakedMap>& maps) {
    OutputFiles pictures;
    for (std::size_t i = 0; i < files_.size(); ++i) {
        putImage(pictures, files_[i], occlusionImage(maps[i]), flags_.bits);
    }
    return pictures.commit();
}

bool BakePreview::goesOn(bake::BakeSnapshot& snapshot) {
    const auto now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - began_).count();
    if (flags_.seconds > 0.0 && seconds >= flags_.seconds &&
        snapshot.samples() < snapshot.wantedSamples()) {
        remark_ = "ended after " + knownNumber(seconds, 1) + " s with " +
                  std::to_string(snapshot.samples()) + " of " +
                  std::to_string(snapshot.wantedSamples()) +
                  (flags_.method == BakeMethod::Rays ? " rays\n" : " directions\n");
        return false;
    }
    if (!files_.empty() && now >= written_ + kInterval) {
        const Result<std::vector<bake::BakedMap>> maps = snapshot.maps();
        failure_ = maps ? write(*maps) : Failure{ExitCode::Failed, maps.status().message()};
        written_ = Clock::now() + kMostShare * (Clock::now() - now);
    }
    return !failure_;
}

} // namespace aolib::app
