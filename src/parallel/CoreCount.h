#pragma once

#include <algorithm>
#include <thread>

namespace aolib {

/// Returns the number of processor cores, 1 where the system does not report it.
inline int coreCount() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

} // namespace aolib
