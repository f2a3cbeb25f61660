#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

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

/// A value, or the failure that says why there is none.
template <typename T>
class [[nodiscard]] Outcome {
public:
    Outcome(T value) : content_(std::move(value)) {}
    Outcome(Failure failure) : content_(std::move(failure)) {}

    bool ok() const { return std::holds_alternative<T>(content_); }
    explicit operator bool() const { return ok(); }
    const Failure& failure() const { return std::get<Failure>(content_); }
    T& operator*() { return std::get<T>(content_); }
    const T& operator*() const { return std::get<T>(content_); }
    T* operator->() { return &std::get<T>(content_); }
    const T* operator->() const { return &std::get<T>(content_); }

private:
    std::variant<T, Failure> content_;
};

} // namespace aolib::app
