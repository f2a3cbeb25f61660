#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace aolib::app {

/// Shows on stderr how far a long task is, from its second second on: a bar on a terminal, else a
/// line now and then. A thread of its own draws it, so that it also lives through calls that block.
class Progress {
public:
    Progress();
    /// Ends it; a bar is wiped away.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Starts a part of the task: "town: tracing the truth". How far it is, is unknown at first.
    void begin(const std::string& stage);
    /// How far the part is, 0 to 1.
    void update(double fraction) { fraction_ = fraction; }
    /// Nothing to show until the next begin(): wipes the bar away, so that results can be printed.
    void pause();

    /// For functions that report a fraction and may be cancelled; never cancels.
    std::function<bool(double)> callback();

private:
    using Clock = std::chrono::steady_clock;

    void loop();
    void show(Clock::time_point now);
    void wipe();

    const bool terminal_;
    std::atomic<double> fraction_{-1.0};
    std::mutex mutex_;
    std::condition_variable wake_;
    bool stop_ = false;
    std::string stage_; ///< empty while paused
    Clock::time_point stageBegan_;
    Clock::time_point lastShown_;
    std::size_t shownWidth_ = 0; ///< characters of the bar on the screen
    std::thread thread_;
};

} // namespace aolib::app
