#include "app/Progress.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <sstream>

#include <unistd.h>

namespace aolib::app {

namespace {

using namespace std::chrono_literals;

constexpr auto kQuiet = 1s;          ///< tasks shorter than this stay silent
constexpr auto kBarInterval = 200ms; ///< between redrawings on a terminal
constexpr auto kLineInterval = 10s;  ///< between lines in a log
constexpr int kBarCells = 24;
constexpr double kForetold = 0.02; ///< from this share on the time left is told

std::string percent(double fraction) {
    return std::to_string(static_cast<int>(100.0 * std::clamp(fraction, 0.0, 1.0))) + "%";
}

std::string bar(double fraction) {
    const int filled = static_cast<int>(kBarCells * std::clamp(fraction, 0.0, 1.0));
    std::string cells(static_cast<std::size_t>(kBarCells), '.');
    std::fill_n(cells.begin(), filled, '#');
    return "[" + cells + "] " + percent(fraction);
}

} // namespace

Progress::Progress() : terminal_(isatty(STDERR_FILENO) != 0), thread_([this] { loop(); }) {}

Progress::~Progress() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wake_.notify_one();
    thread_.join();
    wipe();
}

void Progress::begin(const std::string& stage) {
    const std::lock_guard lock(mutex_);
    stage_ = stage;
    fraction_ = -1.0;
    stageBegan_ = Clock::now();
    lastShown_ = {};
}

void Progress::pause() {
    const std::lock_guard lock(mutex_);
    stage_.clear();
    wipe();
}

std::function<bool(double)> Progress::callback() {
    return [this](double fraction) {
        update(fraction);
        return true;
    };
}

void Progress::loop() {
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, kBarInterval, [this] { return stop_; })) {
        const Clock::time_point now = Clock::now();
        const auto interval = terminal_ ? Clock::duration(kBarInterval) : kLineInterval;
        if (!stage_.empty() && now - stageBegan_ >= kQuiet && now - lastShown_ >= interval) {
            show(now);
        }
    }
}

void Progress::show(Clock::time_point now) {
    const double fraction = fraction_;
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now - stageBegan_);
    std::ostringstream text;
    text << stage_ << ' ';
    if (fraction >= 0.0) {
        text << (terminal_ ? bar(fraction) : percent(fraction)) << ' ';
    }
    text << seconds.count() << " s";
    if (fraction >= kForetold && fraction < 1.0) {
        const double left = static_cast<double>(seconds.count()) * (1.0 - fraction) / fraction;
        text << ", about " << static_cast<int>(left + 1.0) << " s left";
    }
    if (terminal_) {
        const std::size_t width = text.str().size();
        const std::size_t rest = shownWidth_ > width ? shownWidth_ - width : 0;
        std::cerr << '\r' << text.str() << std::string(rest, ' ') << std::flush;
        shownWidth_ = width;
    } else {
        std::cerr << text.str() << std::endl;
    }
    lastShown_ = now;
}

void Progress::wipe() {
    if (shownWidth_ > 0) {
        std::cerr << '\r' << std::string(shownWidth_, ' ') << '\r' << std::flush;
        shownWidth_ = 0;
    }
}

} // namespace aolib::app
