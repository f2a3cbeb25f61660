#pragma once

#include <optional>
#include <string>

#include <aolib/Status.h>

namespace aolib {

/// Why a picture could not be read, written or compared. The message names the file or the pixel.
struct ImageError {
    std::string message;
};

/// Nothing when all went well.
using ImageOutcome = std::optional<ImageError>;

} // namespace aolib
