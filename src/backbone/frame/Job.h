#pragma once

#include <optional>

#include "backbone/frame/FrameBudget.h"

namespace aolib {

/// Work that is done in units, of which a frame does as many as its budget has room for.
class AbstractJob {
public:
    AbstractJob() = default;
    virtual ~AbstractJob() = default;
    AbstractJob(const AbstractJob&) = delete;
    AbstractJob& operator=(const AbstractJob&) = delete;

    /// Returns the kind of the next unit; none if no work is left at present.
    virtual std::optional<WorkUnit> next() = 0;
    /// Whether the next unit can be done without waiting for the GPU or for worker threads.
    virtual bool isReady() { return true; }
    /// Does at most `most` units of the next kind. @return number of units done
    virtual Result<int> step(int most) = 0;
    /// Waits until the next unit is ready, or for this long.
    virtual void await(double /*milliseconds*/) {}
};

/// Does a job's units while the frame's budget has room. @return whether nothing is left to do
Result<bool> runWithinBudget(FrameBudget& budget, AbstractJob& job);
/// Does all units of a job; waits for the GPU and for worker threads.
AoStatus runToEnd(AbstractJob& job);

} // namespace aolib
