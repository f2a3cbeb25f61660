#include "platform/EglContext.h"

#include "platform/EglDisplay.h"

#include <utility>

namespace aolib {
namespace {

void* eglLoader(const char* name) {
    return reinterpret_cast<void*>(eglGetProcAddress(name));
}

void releaseEgl() {
    const EGLDisplay display = eglGetCurrentDisplay();
    if (display != EGL_NO_DISPLAY) {
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
}

class EglContext final : public GlContext {
public:
    static Result<std::unique_ptr<GlContext>> create(const EglPlatform& platform,
                                                     const ContextRequest& request);
    ~EglContext() override;

    LoaderFunction loader() const override { return eglLoader; }
    ContextRequest::Api api() const override { return ContextRequest::Api::Egl; }
    std::string platformName() const override { return display_.name(); }

protected:
    AoStatus bind() override;
    bool isBound() const override;
    ReleaseFunction releaseFunction() const override { return releaseEgl; }

private:
    explicit EglContext(EglDisplay display) : display_(std::move(display)) {}
    AoStatus chooseConfig(const ContextRequest& request);
    AoStatus createContext(const ContextRequest& request);
    AoStatus createSurface(const ContextRequest& request);
    AoStatus failure(const std::string& what) const;

    EglDisplay display_;
    EGLConfig config_ = nullptr;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface surface_ = EGL_NO_SURFACE;
    bool needsSurface_ = false;
};

Result<std::unique_ptr<GlContext>> EglContext::create(const EglPlatform& platform,
                                                      const ContextRequest& request) {
    auto display = EglDisplay::open(platform);
    if (!display.ok()) {
        return display.status();
    }
    std::unique_ptr<EglContext> made(new EglContext(std::move(display.value())));
    made->needsSurface_ =
        request.defaultFramebuffer || !made->display_.has("EGL_KHR_surfaceless_context");
    if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) {
        return made->failure("it has no OpenGL");
    }
    if (AoStatus status = made->chooseConfig(request); !status.ok()) {
        return status;
    }
    if (AoStatus status = made->createContext(request); !status.ok()) {
        return status;
    }
    if (AoStatus status = made->createSurface(request); !status.ok()) {
        return status;
    }
    if (AoStatus status = made->makeCurrent(); !status.ok()) {
        return status;
    }
    return std::unique_ptr<GlContext>(std::move(made));
}

AoStatus EglContext::failure(const std::string& what) const {
    return {StatusCode::NoContext,
            display_.name() + ": " + what + " (" + eglErrorName(eglGetError()) + ")."};
}

AoStatus EglContext::chooseConfig(const ContextRequest& request) {
    const bool framebuffer = request.defaultFramebuffer;
    const EGLint attributes[] = {EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT,
                                 EGL_SURFACE_TYPE,
                                 needsSurface_ ? EGL_PBUFFER_BIT : 0,
                                 EGL_RED_SIZE,
                                 8,
                                 EGL_GREEN_SIZE,
                                 8,
                                 EGL_BLUE_SIZE,
                                 8,
                                 EGL_ALPHA_SIZE,
                                 8,
                                 EGL_DEPTH_SIZE,
                                 framebuffer ? 24 : 0,
                                 EGL_STENCIL_SIZE,
                                 framebuffer ? 8 : 0,
                                 EGL_SAMPLE_BUFFERS,
                                 framebuffer && request.samples > 0 ? 1 : 0,
                                 EGL_SAMPLES,
                                 framebuffer ? request.samples : 0,
                                 EGL_NONE};
    EGLint count = 0;
    if (eglChooseConfig(display_.handle(), attributes, &config_, 1, &count) == EGL_FALSE ||
        count < 1) {
        return failure("no framebuffer configuration has 8 bits a channel" +
                       (framebuffer ? ", 24 bits of depth, 8 of stencil and " +
                                          std::to_string(request.samples) + " samples"
                                    : std::string()));
    }
    return {};
}

AoStatus EglContext::createContext(const ContextRequest& request) {
    const bool core = request.profile == ContextRequest::Profile::Core;
    // EGL 1.4 knows the same things under EGL_KHR_create_context, all but the debug flag by the
    // same numbers.
    EGLint debugName = EGL_NONE;
    EGLint debugValue = EGL_NONE;
    if (request.debug) {
        const bool modern = display_.atLeast(1, 5);
        debugName = modern ? EGL_CONTEXT_OPENGL_DEBUG : EGL_CONTEXT_FLAGS_KHR;
        debugValue = modern ? EGL_TRUE : EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR;
    }
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 request.major,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 request.minor,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 core ? EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT
                                      : EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                                 debugName,
                                 debugValue,
                                 EGL_NONE};
    context_ = eglCreateContext(display_.handle(), config_, EGL_NO_CONTEXT, attributes);
    if (context_ == EGL_NO_CONTEXT) {
        return failure("no " + wantedContext(request));
    }
    return {};
}

AoStatus EglContext::createSurface(const ContextRequest& request) {
    if (!needsSurface_) {
        return {};
    }
    constexpr EGLint unseenSize = 16; // of a framebuffer that nobody draws to
    const EGLint width = request.defaultFramebuffer ? request.width : unseenSize;
    const EGLint height = request.defaultFramebuffer ? request.height : unseenSize;
    const EGLint attributes[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    surface_ = eglCreatePbufferSurface(display_.handle(), config_, attributes);
    if (surface_ == EGL_NO_SURFACE) {
        return failure("no pbuffer of " + std::to_string(width) + " x " + std::to_string(height) +
                       " pixels");
    }
    return {};
}

EglContext::~EglContext() {
    doneCurrent();
    if (surface_ != EGL_NO_SURFACE) {
        eglDestroySurface(display_.handle(), surface_);
    }
    if (context_ != EGL_NO_CONTEXT) {
        eglDestroyContext(display_.handle(), context_);
    }
}

AoStatus EglContext::bind() {
    eglBindAPI(EGL_OPENGL_API); // the choice is per thread, and this may be a new one
    if (eglMakeCurrent(display_.handle(), surface_, surface_, context_) == EGL_FALSE) {
        return failure("eglMakeCurrent failed");
    }
    return {};
}

bool EglContext::isBound() const {
    return eglGetCurrentContext() == context_;
}

} // namespace

Result<std::unique_ptr<GlContext>> createEglContext(const ContextRequest& request) {
    const auto platforms = findEglPlatforms();
    if (!platforms.ok()) {
        return platforms.status();
    }
    std::string reasons;
    for (const EglPlatform& platform : platforms.value()) {
        auto made = EglContext::create(platform, request);
        if (made.ok()) {
            return made;
        }
        reasons += " " + made.status().message();
    }
    return AoStatus(StatusCode::NoContext, "EGL gave no context." + reasons);
}

} // namespace aolib
