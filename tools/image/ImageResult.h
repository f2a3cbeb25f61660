#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace aolib {

/// Why a picture could not be read, written or compared. The message names the file or the pixel.
struct ImageError {
    std::string message;
};

/// Nothing when all went well.
using ImageOutcome = std::optional<ImageError>;

/// A value, or the error that says why there is none.
template <typename T>
class [[nodiscard]] ImageResult {
public:
    ImageResult(T value) : content_(std::move(value)) {}
    ImageResult(ImageError error) : content_(std::move(error)) {}

    bool ok() const { return std::holds_alternative<T>(content_); }
    explicit operator bool() const { return ok(); }
    /// Empty when there is a value.
    std::string message() const { return ok() ? "" : std::get<ImageError>(content_).message; }
    T& operator*() { return std::get<T>(content_); }
    const T& operator*() const { return std::get<T>(content_); }
    T* operator->() { return &std::get<T>(content_); }
    const T* operator->() const { return &std::get<T>(content_); }

private:
    std::variant<T, ImageError> content_;
};

} // namespace aolib
