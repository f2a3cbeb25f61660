#pragma once

#include <aolib/ProcAddressLoader.h>
#include <aolib/Status.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace aolib {

/// Collects what the driver has to say (KHR_debug) in a context of our own, so that a test can
/// demand silence. Never for a host's context: the callback slot there is the host's.
///
/// ```cpp
/// auto log = DebugLog::install(context->loader());
/// draw();
/// EXPECT_TRUE((*log)->empty()) << (*log)->text();
/// ```
/// Context: the one current at install() must be current when the log is destroyed, too.
/// Messages come in the thread of the call that causes them. Since 0.1.
class DebugLog {
public:
    enum class Severity : std::uint8_t { Low, Medium, High };

    struct Message {
        Severity severity = Severity::Low;
        bool error = false;   ///< the driver calls it an error or undefined behaviour
        std::uint32_t id = 0; ///< the driver's number
        std::string text;
    };

    /// Takes the callback slot and asks for all messages above notification, synchronously.
    /// Errors: NoContext (the loader knows no function), MissingCapability (neither OpenGL 4.3 nor
    /// KHR_debug).
    static Result<std::unique_ptr<DebugLog>> install(const ProcAddressLoader& loader);

    /// Gives the slot back to the callback that had it.
    ~DebugLog();
    DebugLog(const DebugLog&) = delete;
    DebugLog& operator=(const DebugLog&) = delete;

    bool empty() const;
    const std::vector<Message>& messages() const;
    void clear();

    /// One line a message: "high error 1280: GL_INVALID_ENUM in glEnable(...)".
    std::string text() const;

private:
    struct Slot;
    explicit DebugLog(std::unique_ptr<Slot> slot);

    std::unique_ptr<Slot> slot_;
};

} // namespace aolib
