#pragma once

#include <cstddef>
#include <functional>

namespace aolib {

/// Told the share that is done, 0 to 1; returning false cancels. Called from the thread that
/// started the work, never from a worker: first with 0 before any work, last with 1.
using TraceProgress = std::function<bool(double fraction)>;

/// Runs `body(begin, end)` over [0, count) in small pieces on worker threads and waits for them.
/// The pieces' order is not fixed: a body must write only what its own indices name.
/// @param threads  workers; 0 takes one per core.
/// @param body     what it throws ends the loop, and is thrown here once all workers have stopped.
/// Returns false when `progress` cancelled it before all was done. Pieces begun are finished.
bool parallelLoop(std::size_t count, int threads,
                  const std::function<void(std::size_t begin, std::size_t end)>& body,
                  const TraceProgress& progress);

} // namespace aolib
