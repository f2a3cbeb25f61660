#pragma once

#include <chrono>
#include <filesystem>
#include <vector>

#include <aolib/bake/AbstractBaker.h>

#include "app/BakeFlags.h"
#include "app/Failure.h"

namespace aolib::app {

/// Lets people watch a bake in pictures of its maps so far, and ends it when its time is over.
/// Each picture replaces the one before as a whole. They go with it, unless they are to be kept.
class BakePreview {
public:
    /// Its time begins now.
    /// @param files  one per map; empty for no pictures.
    BakePreview(const BakeFlags& flags, std::vector<std::filesystem::path> files)
        : flags_(flags), files_(std::move(files)) {}
    ~BakePreview();
    BakePreview(const BakePreview&) = delete;
    BakePreview& operator=(const BakePreview&) = delete;

    /// Writes pictures now and then. False: it is enough.
    bool goesOn(bake::BakeSnapshot& snapshot);
    MaybeFailure write(const std::vector<bake::BakedMap>& maps);
    void keep() { kept_ = true; }

    /// Why goesOn() ended the bake, if something went wrong.
    const MaybeFailure& failure() const { return failure_; }
    /// A line for people, empty where the bake was not ended.
    const std::string& remark() const { return remark_; }

private:
    using Clock = std::chrono::steady_clock;

    const BakeFlags& flags_;
    std::vector<std::filesystem::path> files_;
    Clock::time_point began_ = Clock::now();
    Clock::time_point written_; ///< when the last pictures were
    MaybeFailure failure_;
    std::string remark_;
    bool kept_ = false;
};

} // namespace aolib::app
