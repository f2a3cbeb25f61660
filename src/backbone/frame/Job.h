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

    /// Kind of the next unit; none where nothing is left to do, as far as is known.
    virtual std::optional<WorkUnit> next() = 0;
    /// Whether the next unit can be done without waiting for the GPU or for worker threads.
    virtual bool isReady() { return true; }
    /// Does units of the next kind. @param most  at most so many. @return how many were done
    virtual Result<int> step(int most) = 0;
    /// Waits until the next unit is ready, or for this long.
    virtual void await(double /*milliseconds*/) {}
};

/// Does a job's units while the frame's budget has room. @return whether nothing is left to do
Result<bool> runWithinBudget(FrameBudget& budget, AbstractJob& job);
/// Does all units of a job, and waits where it must.
AoStatus runToEnd(AbstractJob& job);

} // namespace aolib
