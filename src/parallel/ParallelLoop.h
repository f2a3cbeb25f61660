#pragma once

#include <cstddef>
#include <functional>

namespace aolib {

/// Receives the share of the work that is done, 0 to 1; returning false cancels the loop. Called in
/// the thread that started the loop, never in a worker: first with 0 before any work, last with 1.
using LoopProgress = std::function<bool(double fraction)>;

/// Runs `body(begin, end)` over [0, count) in small pieces on worker threads and waits for them.
/// The order of the pieces is not fixed: a body must write only to elements of its own indices.
/// @param threads  number of workers; 0 starts one per core.
/// @param body     its first exception ends the loop and is rethrown once all workers have stopped.
/// Returns false if `progress` cancelled the loop before its end. Pieces already begun are
/// finished.
bool parallelLoop(std::size_t count, int threads,
                  const std::function<void(std::size_t begin, std::size_t end)>& body,
                  const LoopProgress& progress);

} // namespace aolib
