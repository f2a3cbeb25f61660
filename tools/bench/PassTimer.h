#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <aolib/ProcAddressLoader.h>

namespace aolib::bench {

/// What one pass took, milliseconds, the GPU's work done; passes within it left out.
struct PassTime {
    std::string pass; ///< "blur"; "other" for what belongs to no pass
    double ms = 0.0;
};

/// Times the library's passes from outside: it names them by debug groups, and this hands it
/// functions for those that wait for the GPU and look at the clock. Waiting costs: the passes of a
/// frame add up to a little more than a frame.
///
/// One at a time per thread: OpenGL's functions know no object.
class PassTimer {
public:
    PassTimer();
    ~PassTimer();
    PassTimer(const PassTimer&) = delete;
    PassTimer& operator=(const PassTimer&) = delete;

    /// A loader to give to the library, for as long as this object lives; times are taken only
    /// between start() and stop().
    ProcAddressLoader wrap(const ProcAddressLoader& loader);

    void start();
    /// The passes since start(), in the order of their first beginning; equal names are added up.
    std::vector<PassTime> stop();

private:
    using Clock = std::chrono::steady_clock;
    struct Functions;

    void enter(const std::string& pass);
    void leave();
    /// Gives the time since the last mark to the innermost pass.
    void mark();

    std::unique_ptr<Functions> functions_;
    bool running_ = false;
    Clock::time_point last_;
    std::vector<std::string> stack_;
    std::vector<PassTime> times_;
};

/// Medians pass by pass; a pass that a list lacks counts as 0 there.
std::vector<PassTime> medianPasses(const std::vector<std::vector<PassTime>>& lists);

} // namespace aolib::bench
