#include "backbone/frame/Job.h"

#include <limits>

namespace aolib {

Result<bool> runWithinBudget(FrameBudget& budget, AbstractJob& job) {
    for (auto unit = job.next(); unit; unit = job.next()) {
        const int most = budget.room(*unit);
        if (most == 0 || !job.isReady()) {
            return false;
        }
        budget.start(*unit);
        const auto done = job.step(most);
        if (!done) {
            return done.status();
        }
        budget.done(*done);
    }
    return true;
}

AoStatus runToEnd(AbstractJob& job) {
    constexpr double kPatience = 1000.0; // milliseconds
    while (job.next()) {
        if (!job.isReady()) {
            job.await(kPatience);
            continue;
        }
        if (const auto done = job.step(std::numeric_limits<int>::max()); !done) {
            return done.status();
        }
    }
    return {};
}

} // namespace aolib
