#pragma once

#include <array>

#include <aolib/Status.h>

#include "gl/Container.h"

namespace aolib::gl {

/// Measures the GPU time between begin() and end() by two timestamps, which disturb no query that
/// the host has running. The answer comes frames later and is never waited for. Only the context
/// that measured has it: elsewhere it is on its way, until it is given up.
class GpuTimer {
public:
    GpuTimer() = default;
    static Result<GpuTimer> create(const Functions& gl);

    /// Starts a measurement unless the last one is still on its way.
    void begin();
    void end();
    /// Whether a measurement that begin() started is still to come.
    bool pending() const { return state_ == State::Pending; }
    /// The latest finished measurement, milliseconds; -1 before the first.
    double milliseconds();

private:
    enum class State { Idle, Running, Pending };

    const Functions* gl_ = nullptr;
    std::array<Container, 2> queries_;
    State state_ = State::Idle;
    ContextId context_ = 0; ///< whose queries measure
    int askedElsewhere_ = 0;
    double milliseconds_ = -1.0;
};

} // namespace aolib::gl
