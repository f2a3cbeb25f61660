#include "backbone/frame/FrameBudget.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aolib {

namespace {

/// How fast a unit's cost follows what is measured.
constexpr double kLearning = 0.5;
/// Most units at a time, whatever they seem to cost.
constexpr int kMostUnits = 4096;

double millisecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

/// Whether a kind of unit keeps the GPU busy; else the calling thread's time is all that it costs.
bool usesGpu(WorkUnit kind) {
    return kind != WorkUnit::Upload;
}

void learn(double& cost, double milliseconds, int units) {
    const double perUnit = milliseconds / units;
    cost = cost < 0.0 ? perUnit : cost + kLearning * (perUnit - cost);
}

} // namespace

Result<FrameBudget> FrameBudget::create(const gl::Functions& gl) {
    FrameBudget budget;
    budget.gl_ = &gl;
    budget.software_ = gl.capabilities.software;
    for (Cost& cost : budget.costs_) {
        auto timer = gl::GpuTimer::create(gl);
        if (!timer) {
            return timer.status();
        }
        cost.timer = std::move(*timer);
    }
    return budget;
}

void FrameBudget::beginFrame(double milliseconds) {
    for (Cost& cost : costs_) {
        const double measured = cost.timer.milliseconds();
        if (cost.timed > 0 && !cost.timer.pending()) {
            learn(cost.gpu, measured, std::exchange(cost.timed, 0));
        }
        if (!software_ && cost.inFrame > 0) {
            cost.trusted = std::min(2 * cost.inFrame + 1, kMostUnits);
        }
        cost.inFrame = 0;
    }
    frameBegan_ = Clock::now();
    milliseconds_ = milliseconds;
    gpuSpent_ = 0.0;
    unknown_ = false;
    worked_ = false;
    waited_ = false;
}

void FrameBudget::waitForHost() {
    if (software_ && !waited_) {
        const Clock::time_point before = Clock::now();
        gl_->Finish();
        frameBegan_ += Clock::now() - before;
        waited_ = true;
    }
}

double FrameBudget::spent() const {
    return std::max(gpuSpent_, millisecondsSince(frameBegan_));
}

int FrameBudget::room(WorkUnit kind) {
    if (usesGpu(kind)) {
        waitForHost();
    }
    const Cost& of = cost(kind);
    const int least = worked_ ? 0 : 1;
    const double left = milliseconds_ - spent();
    const bool timedAtOnce = software_ || !usesGpu(kind);
    if (!of.known()) {
        return timedAtOnce && left > 0.0 ? 1 : least;
    }
    if (unknown_) {
        return least;
    }
    const double fits = std::min(left / std::max(of.perUnit(), 1e-6), double{kMostUnits});
    if (timedAtOnce) { // half of them, then again: units of a kind differ
        const int half = static_cast<int>(std::ceil(0.5 * std::floor(fits)));
        return std::max(std::min(half, of.trusted), least);
    }
    return std::max(std::min(static_cast<int>(fits), of.trusted - of.inFrame), least);
}

void FrameBudget::start(WorkUnit kind) {
    current_ = kind;
    Cost& of = cost(kind);
    of.since = Clock::now();
    if (!software_ && usesGpu(kind) && of.timed == 0) {
        of.timer.begin();
    }
}

void FrameBudget::done(int units) {
    units = std::max(units, 1);
    Cost& of = cost(current_);
    if (software_ || !usesGpu(current_)) {
        if (usesGpu(current_)) {
            gl_->Finish();
        }
        of.gpu = 0.0; // it is in the thread's
        of.trusted = std::min(2 * units + 1, kMostUnits);
    } else if (of.timed == 0) {
        of.timer.end();
        of.timed = units;
    }
    learn(of.cpu, millisecondsSince(of.since), units);
    unknown_ = unknown_ || !of.known();
    gpuSpent_ += units * std::max(of.gpu, 0.0);
    of.inFrame += units;
    worked_ = true;
}

} // namespace aolib
