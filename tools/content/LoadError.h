#pragma once

#include <string>

#include <aolib/Status.h>

namespace aolib {

/// Why a file could not be read: one sentence that names the file and the reason.
struct LoadError {
    std::string sentence;
};

} // namespace aolib
