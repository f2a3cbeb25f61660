#pragma once

#include <optional>
#include <string>
#include <utility>

#include <aolib/Status.h>

namespace aolib::app {

/// What the program tells the shell.
enum class ExitCode : int {
    Ok = 0,
    Failed = 1,   ///< none of the reasons below, such as a full disk
    BadInput = 2, ///< an option or a file that cannot be used; nothing was written
    Graphics = 3, ///< OpenGL or its driver failed
};

/// Why a command stopped: one sentence that names the option or the file, and the reason.
struct Failure {
    ExitCode exit = ExitCode::Failed;
    std::string sentence;
};

inline Failure badInput(std::string sentence) {
    return {ExitCode::BadInput, std::move(sentence)};
}
inline Failure graphicsFailure(std::string sentence) {
    return {ExitCode::Graphics, std::move(sentence)};
}

/// Nothing when all went well.
using MaybeFailure = std::optional<Failure>;

} // namespace aolib::app
