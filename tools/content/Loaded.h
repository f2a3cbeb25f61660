#pragma once

#include <string>
#include <utility>
#include <variant>

namespace aolib {

/// Why content could not be had: one sentence that names the file and the reason.
struct LoadError {
    std::string sentence;
};

/// A value, or the sentence that says why there is none. The counterpart of `Result` for files,
/// for which the library has no status codes.
template <typename T>
class [[nodiscard]] Loaded {
public:
    Loaded(T value) : content_(std::move(value)) {}
    Loaded(LoadError error) : content_(std::move(error)) {}

    bool ok() const { return std::holds_alternative<T>(content_); }
    explicit operator bool() const { return ok(); }
    /// Only when not ok().
    const LoadError& error() const { return std::get<LoadError>(content_); }
    /// The reason, empty when ok().
    std::string sentence() const { return ok() ? std::string() : error().sentence; }
    T& value() { return std::get<T>(content_); }
    const T& value() const { return std::get<T>(content_); }
    T& operator*() { return value(); }
    const T& operator*() const { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

private:
    std::variant<T, LoadError> content_;
};

} // namespace aolib
