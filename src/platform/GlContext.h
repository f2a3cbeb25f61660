#pragma once

#include "platform/ContextRequest.h"

#include <aolib/ProcAddressLoader.h>
#include <aolib/Status.h>

#include <memory>
#include <string>
#include <vector>

namespace aolib {

/// What the driver says about a context that was created.
struct ContextInfo {
    std::string vendor;   ///< GL_VENDOR
    std::string renderer; ///< GL_RENDERER
    std::string version;  ///< GL_VERSION
    int major = 0;
    int minor = 0;
    ContextRequest::Profile profile = ContextRequest::Profile::Compatibility;
    bool debug = false;              ///< the context has the debug flag
    bool defaultFramebuffer = false; ///< framebuffer 0 can be drawn to
    int width = 0;                   ///< of the default framebuffer, as created; 0 if there is none
    int height = 0;                  ///< of the default framebuffer, as created; 0 if there is none
};

/// An OpenGL context for our own tools, tests and examples. The core library never makes one: it
/// is a guest in the host's. Made by createContext(), destroyed with the object. Since 0.1.
///
/// Thread: a context is current in at most one thread. Destroy it in the thread where it is
/// current, or after doneCurrent(). GLFW contexts belong to the main thread.
class GlContext {
public:
    /// A plain function, valid as long as the process lives; converts to ProcAddressLoader.
    using LoaderFunction = void* (*)(const char* name);

    virtual ~GlContext() = default;
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    /// Makes the context current in this thread, after releasing the one that another API (EGL,
    /// OSMesa, GLFW) has made current here: drivers share a hidden slot and would mix them up.
    /// Errors: NoContext, with the API's reason.
    AoStatus makeCurrent();

    /// Leaves this thread without a context, if this one was current in it; else does nothing.
    void doneCurrent();

    /// Whether the context is current in this thread.
    bool isCurrent() const;

    /// The API's own function to look up OpenGL functions.
    virtual LoaderFunction loader() const = 0;

    /// The address of an OpenGL function, null if unknown. The context must be current.
    void* getProcAddress(const char* name) const { return loader()(name); }

    virtual ContextRequest::Api api() const = 0;

    /// The way the context was found: "EGL surfaceless", "OSMesa", "GLFW window".
    virtual std::string platformName() const = 0;

    /// The GLFWwindow* of a GLFW context, else null.
    virtual void* nativeWindow() const { return nullptr; }

    /// Shows what was drawn to a window; without one does nothing.
    virtual void swapBuffers() {}

    const ContextInfo& info() const { return info_; }

    /// One line for logs: "EGL surfaceless, llvmpipe (LLVM 15.0.6, 256 bits), 4.5 core,
    /// Mesa 22.3.6".
    std::string describe() const;

protected:
    GlContext() = default;

    /// Releases whatever this API has made current in the calling thread.
    using ReleaseFunction = void (*)();

    virtual AoStatus bind() = 0;
    virtual bool isBound() const = 0;
    virtual ReleaseFunction releaseFunction() const = 0;

private:
    friend Result<std::unique_ptr<GlContext>> createContext(const ContextRequest& request);
    AoStatus readInfo(const ContextRequest& request);

    ContextInfo info_;
};

/// The APIs that this build knows, in the order in which to try them. Whether one works here is
/// found out by createContext().
std::vector<ContextRequest::Api> availableApis();

/// Makes a context; on success it is current in this thread. The one that was current is released,
/// also on failure.
///
/// EGL takes the first that works of: hardware devices, software devices, Mesa's surfaceless
/// platform, the default display. The environment variable AOLIB_EGL_DEVICE (an index, from 0)
/// insists on one device. No display server, and no rights, are needed.
///
/// Errors: InvalidOption (a size below 1, a negative number of samples, samples with OSMesa),
/// MissingCapability (the API was not built, or its library is not installed), NoContext (nothing
/// here gives such a context; the message lists what was tried and why it failed). Since 0.1.
Result<std::unique_ptr<GlContext>> createContext(const ContextRequest& request);

/// The same without a window, by whichever API works: EGL, else OSMesa. `request.api` is not read.
/// Errors: as createContext(), with the reasons of both. Since 0.1.
Result<std::unique_ptr<GlContext>> createOffscreenContext(ContextRequest request);

} // namespace aolib
