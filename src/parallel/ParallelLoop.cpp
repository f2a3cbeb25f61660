#include "parallel/ParallelLoop.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "parallel/CoreCount.h"

namespace aolib {

namespace {

/// Indices per piece: long enough to make the bookkeeping free, short enough to cancel promptly.
constexpr std::size_t pieceLength = 16;
/// The longest wait between two reports of progress.
constexpr std::chrono::milliseconds reportInterval{50};

unsigned workerCount(int threads, std::size_t pieces) {
    const auto wanted = static_cast<std::size_t>(threads > 0 ? threads : coreCount());
    return static_cast<unsigned>(std::min(wanted, pieces));
}

} // namespace

bool parallelLoop(std::size_t count, int threads,
                  const std::function<void(std::size_t begin, std::size_t end)>& body,
                  const LoopProgress& progress) {
    if (progress && !progress(0.0)) {
        return false;
    }
    const std::size_t pieces = (count + pieceLength - 1) / pieceLength;
    std::atomic<std::size_t> next{0};
    std::mutex mutex;
    std::condition_variable finished;
    std::size_t done = 0;
    unsigned running = workerCount(threads, pieces);
    bool cancelled = false;
    std::exception_ptr thrown; // the first; a thread that lets one go ends the program

    const auto work = [&](const std::stop_token& stop) {
        try {
            for (std::size_t piece = next++; piece < pieces && !stop.stop_requested();
                 piece = next++) {
                const std::size_t begin = piece * pieceLength;
                body(begin, std::min(begin + pieceLength, count));
                const std::scoped_lock lock(mutex);
                ++done;
            }
        } catch (...) {
            const std::scoped_lock lock(mutex);
            thrown = thrown ? thrown : std::current_exception();
            next = pieces; // nobody begins another
        }
        const std::scoped_lock lock(mutex);
        --running;
        finished.notify_all();
    };
    std::vector<std::jthread> workers;
    for (unsigned i = running; i > 0; --i) {
        workers.emplace_back(work);
    }
    std::unique_lock lock(mutex);
    while (!finished.wait_for(lock, reportInterval, [&] { return running == 0; })) {
        const double fraction = static_cast<double>(done) / static_cast<double>(pieces);
        lock.unlock();
        if (!cancelled && progress && !progress(fraction)) {
            cancelled = true;
            std::ranges::for_each(workers, [](std::jthread& worker) { worker.request_stop(); });
        }
        lock.lock();
    }
    lock.unlock();
    if (thrown) {
        std::rethrow_exception(thrown);
    }
    if (done < pieces) {
        return false;
    }
    if (progress) {
        progress(1.0);
    }
    return true;
}

} // namespace aolib
