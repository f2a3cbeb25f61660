#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>

#include <aolib/Status.h>

#include "gl/GpuTimer.h"

namespace aolib {

/// Kinds of units of work that cost about the same each.
enum class WorkUnit {
    Prepare, ///< targets made and cleared
    Draw,    ///< the scene, before one face of a cube map
    Read,    ///< what the GPU answered for one face
    Peel,    ///< half a layer of one face
    Texels,  ///< a pass over a tile
    Keep,    ///< a tile's texels, written to where they are kept
    Pixels,  ///< a pass over a tile of a view
    Upload,  ///< a tile's texels, sent to where they are kept
};

/// Limits the work of a frame to a time, in milliseconds, from the measured cost of earlier units.
///
/// On a graphics card, timer queries measure the time and answer some frames later. Therefore a
/// kind of unknown cost has a frame to itself, and the units of a kind about double per frame at
/// most. A software rasteriser runs on the host's CPU time: each piece of work is waited for, and
/// the clock measures the rest of the budget.
class FrameBudget {
public:
    FrameBudget() = default;
    /// Errors: OutOfMemory.
    static Result<FrameBudget> create(const gl::Functions& gl);

    /// Begins a frame. @param milliseconds  that its work may take.
    void beginFrame(double milliseconds);
    /// How many units of a kind the frame has room for. At least one before the first unit.
    int room(WorkUnit kind);
    /// Around a piece of work of at least one unit.
    void start(WorkUnit kind);
    void done(int units);

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::size_t kKinds = 8;

    struct Cost {
        gl::GpuTimer timer;
        int timed = 0;     ///< units that the timer measures
        double gpu = -1.0; ///< milliseconds per unit, smoothed; -1 until known
        double cpu = -1.0; ///< CPU milliseconds per unit, smoothed; -1 until known
        int trusted = 1;   ///< units that may be done: at a time, or in a frame
        int inFrame = 0;   ///< units done in this frame
        Clock::time_point since;

        bool known() const { return gpu >= 0.0; }
        double perUnit() const { return std::max(gpu, cpu); }
    };
    Cost& cost(WorkUnit kind) { return costs_[static_cast<std::size_t>(kind)]; }
    double spent() const;
    /// Waits before the first unit of a frame, so that the host's own drawing is not measured.
    void waitForHost();

    const gl::Functions* gl_ = nullptr;
    bool software_ = false;
    std::array<Cost, kKinds> costs_;
    WorkUnit current_ = WorkUnit::Prepare;
    Clock::time_point frameBegan_;
    double milliseconds_ = 0.0;
    double gpuSpent_ = 0.0; ///< as far as it is known
    bool unknown_ = false;  ///< a unit of unknown cost was done in this frame
    bool worked_ = false;
    bool waited_ = false; ///< a software rasteriser has drawn all that the host asked for
};

} // namespace aolib
