#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/Failure.h"
#include "gl/Functions.h"
#include "platform/ContextRequest.h"
#include "platform/DebugLog.h"
#include "platform/GlContext.h"

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

/// Which OpenGL context a command draws in.
struct GlFlags {
    std::optional<ContextRequest::Api> api; ///< none: EGL, else OSMesa
    ContextRequest::Profile profile = ContextRequest::Profile::Core;
    bool strict = false; ///< a message of the driver above notification is a failure

    /// Adds --context, --profile and --gl-debug to a command. The object must outlive it.
    void attach(CLI::App& command);
};

/// A context that is current, its functions, and what its driver had to say.
class GlSession {
public:
    /// Errors: Graphics.
    static Result<GlSession, Failure> open(const GlFlags& flags);
    /// The same for a context of one's own choice, such as a window. Errors: Graphics.
    static Result<GlSession, Failure> open(ContextRequest request, bool strict);

    const gl::Functions& gl() const { return *gl_; }
    GlContext& context() const { return *context_; }
    ProcAddressLoader loader() const { return context_->loader(); }
    /// One line: "EGL surfaceless, llvmpipe ..., 4.5 core, Mesa 22.3.6".
    std::string describe() const { return context_->describe(); }

    /// After the work: repeats the driver's messages on stderr as warnings; a failure when strict.
    MaybeFailure reviewMessages() const;

private:
    GlSession() = default;
    static Result<GlSession, Failure> adopt(Result<std::unique_ptr<GlContext>> context, bool debug,
                                            bool strict);

    // In this order: the log gives the callback slot back before the context goes.
    std::unique_ptr<GlContext> context_;
    std::unique_ptr<DebugLog> log_;
    std::unique_ptr<gl::Functions> gl_;
    bool strict_ = false;
};

} // namespace aolib::app
