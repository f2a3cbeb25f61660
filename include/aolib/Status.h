#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace aolib {

/// The reason of a failure. Since 0.1.
enum class StatusCode : std::uint8_t {
    Ok,
    InvalidCallOrder,    ///< the call is not allowed here; the message says what to call first
    InvalidPosition,     ///< a position or transform is NaN or infinite
    InvalidNormal,       ///< a normal is NaN or infinite, or normals and positions differ in number
    InvalidIndex,        ///< an index is not below the number of vertices of its mesh
    IncompletePrimitive, ///< the number of indices does not fit the primitive
    EmptyMesh,           ///< a mesh without vertices or without triangles
    InvalidPrimitive,    ///< a value that is not an AoPrimitive
    UnknownMesh,         ///< no mesh has this id
    UnknownCubeMap,      ///< no cube map has this id
    NoScene,             ///< there are no triangles yet
    NoCamera,            ///< aoSetCamera() was not called and GL holds no matrices to read
    InvalidCamera,       ///< a matrix is not finite, cannot be inverted or contradicts the position
    InvalidOption,       ///< an option lies outside its range
    InvalidFramebuffer,  ///< the host's framebuffer is incomplete, has no depth, or no size
    MissingCapability,   ///< the context lacks a function or a size that is needed
    NoContext,           ///< no OpenGL context is current, the loader returns no address, or
                         ///< abandon() was called
    WrongContext,        ///< the current context shares no objects with the one of create()
    ShaderError,         ///< a shader did not compile or link; the message holds the driver's log
    OutOfMemory,    ///< GL could not create a texture, buffer or framebuffer of the needed size
    Cancelled,      ///< the host's progress callback returned false; there is no result
    CallbackFailed, ///< a callback of the host threw an exception
};

/// Returns the name of a code, for messages and tests: `statusName(StatusCode::Ok) == "Ok"`.
constexpr const char* statusName(StatusCode code) {
    switch (code) {
    case StatusCode::Ok:
        return "Ok";
    case StatusCode::InvalidCallOrder:
        return "InvalidCallOrder";
    case StatusCode::InvalidPosition:
        return "InvalidPosition";
    case StatusCode::InvalidNormal:
        return "InvalidNormal";
    case StatusCode::InvalidIndex:
        return "InvalidIndex";
    case StatusCode::IncompletePrimitive:
        return "IncompletePrimitive";
    case StatusCode::EmptyMesh:
        return "EmptyMesh";
    case StatusCode::InvalidPrimitive:
        return "InvalidPrimitive";
    case StatusCode::UnknownMesh:
        return "UnknownMesh";
    case StatusCode::UnknownCubeMap:
        return "UnknownCubeMap";
    case StatusCode::NoScene:
        return "NoScene";
    case StatusCode::NoCamera:
        return "NoCamera";
    case StatusCode::InvalidCamera:
        return "InvalidCamera";
    case StatusCode::InvalidOption:
        return "InvalidOption";
    case StatusCode::InvalidFramebuffer:
        return "InvalidFramebuffer";
    case StatusCode::MissingCapability:
        return "MissingCapability";
    case StatusCode::NoContext:
        return "NoContext";
    case StatusCode::WrongContext:
        return "WrongContext";
    case StatusCode::ShaderError:
        return "ShaderError";
    case StatusCode::OutOfMemory:
        return "OutOfMemory";
    case StatusCode::Cancelled:
        return "Cancelled";
    case StatusCode::CallbackFailed:
        return "CallbackFailed";
    }
    return "unknown";
}

/// The outcome of a call: a code, and for failures a message with the values. A host may ignore
/// the outcome; `AmbientOcclusion::lastStatus()` keeps the latest failure. The prefix avoids the
/// macro `Status` of Xlib.h. Since 0.1.
class AoStatus {
public:
    AoStatus() = default;
    AoStatus(StatusCode code, std::string message) : code_(code), message_(std::move(message)) {}

    bool ok() const { return code_ == StatusCode::Ok; }
    explicit operator bool() const { return ok(); }
    StatusCode code() const { return code_; }
    const std::string& message() const { return message_; }

private:
    StatusCode code_ = StatusCode::Ok;
    std::string message_;
};

#if !defined(Status)
/// Former name of AoStatus; absent if Xlib.h was included before.
using Status [[deprecated("use AoStatus")]] = AoStatus;
#endif

/// A value, or the error that prevented the value: a status, unless another type is named.
/// Since 0.1.
template <typename T, typename E = AoStatus>
class [[nodiscard]] Result {
public:
    Result(T value) : content_(std::move(value)) {}
    Result(E error) : content_(std::move(error)) {}

    bool ok() const { return std::holds_alternative<T>(content_); }
    explicit operator bool() const { return ok(); }
    /// The error; only when not ok().
    const E& error() const { return std::get<E>(content_); }
    /// The error, or Ok where there is a value.
    AoStatus status() const requires std::is_same_v<E, AoStatus> {
        return ok() ? AoStatus() : error();
    }
    T& value() { return std::get<T>(content_); }
    const T& value() const { return std::get<T>(content_); }
    T& operator*() { return value(); }
    const T& operator*() const { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }

private:
    std::variant<T, E> content_;
};

} // namespace aolib
