#include "platform/GlContext.h"

#include "platform/EglContext.h"
#include "platform/GlfwContext.h"
#include "platform/OsMesaContext.h"

#include <GL/glcorearb.h>

#include <utility>

namespace aolib {
namespace {

/// How to release what is current in this thread; null if nothing of ours is.
thread_local void (*releaseCurrent)() = nullptr;

void releaseThread() {
    if (releaseCurrent != nullptr) {
        releaseCurrent();
        releaseCurrent = nullptr;
    }
}

AoStatus checkRequest(const ContextRequest& request) {
    if (request.width < 1 || request.height < 1) {
        return {StatusCode::InvalidOption,
                "A default framebuffer of " + std::to_string(request.width) + " x " +
                    std::to_string(request.height) + " pixels was asked for; the least is 1 x 1."};
    }
    if (request.samples < 0) {
        return {StatusCode::InvalidOption, "The number of samples, " +
                                               std::to_string(request.samples) +
                                               ", must not be negative."};
    }
    return {};
}

Result<std::unique_ptr<GlContext>> createByApi(const ContextRequest& request) {
    switch (request.api) {
    case ContextRequest::Api::Egl:
        return createEglContext(request);
    case ContextRequest::Api::OsMesa:
        return createOsMesaContext(request);
    case ContextRequest::Api::Glfw:
        return createGlfwContext(request);
    }
    return AoStatus(StatusCode::InvalidOption, "The request names no context API.");
}

/// GL_VERSION without the number and the profile, which describe() prints itself.
std::string driverOf(const std::string& version) {
    const auto space = version.find(' ');
    if (space == std::string::npos) {
        return {};
    }
    std::string driver = version.substr(space + 1);
    if (!driver.empty() && driver.front() == '(') {
        const auto close = driver.find(") ");
        driver = close == std::string::npos ? std::string() : driver.substr(close + 2);
    }
    return driver;
}

} // namespace

AoStatus GlContext::makeCurrent() {
    if (releaseCurrent != releaseFunction()) {
        releaseThread();
    }
    AoStatus status = bind();
    if (status.ok()) {
        releaseCurrent = releaseFunction();
    }
    return status;
}

void GlContext::doneCurrent() {
    if (isCurrent()) {
        releaseThread();
    }
}

bool GlContext::isCurrent() const {
    return releaseCurrent == releaseFunction() && isBound();
}

AoStatus GlContext::readInfo(const ContextRequest& request) {
    const auto getString = reinterpret_cast<PFNGLGETSTRINGPROC>(getProcAddress("glGetString"));
    const auto getIntegerv =
        reinterpret_cast<PFNGLGETINTEGERVPROC>(getProcAddress("glGetIntegerv"));
    if (getString == nullptr || getIntegerv == nullptr) {
        return {StatusCode::NoContext,
                platformName() + " gave a context, but no address of glGetString."};
    }
    const auto text = [&](GLenum name) {
        const GLubyte* bytes = getString(name);
        return std::string(bytes == nullptr ? "" : reinterpret_cast<const char*>(bytes));
    };
    info_.vendor = text(GL_VENDOR);
    info_.renderer = text(GL_RENDERER);
    info_.version = text(GL_VERSION);
    if (info_.version.empty()) {
        return {StatusCode::NoContext,
                platformName() + " gave a context, but its glGetString(GL_VERSION) is empty."};
    }
    const auto integer = [&](GLenum name) {
        GLint value = 0;
        getIntegerv(name, &value);
        return value;
    };
    info_.major = integer(GL_MAJOR_VERSION);
    info_.minor = integer(GL_MINOR_VERSION);
    if (info_.major > 3 || (info_.major == 3 && info_.minor >= 2)) {
        if ((integer(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT) != 0) {
            info_.profile = ContextRequest::Profile::Core;
        }
    }
    if (info_.major >= 3) {
        info_.debug = (integer(GL_CONTEXT_FLAGS) & GL_CONTEXT_FLAG_DEBUG_BIT) != 0;
    }
    info_.defaultFramebuffer =
        request.api != ContextRequest::Api::Egl || request.defaultFramebuffer;
    info_.width = info_.defaultFramebuffer ? request.width : 0;
    info_.height = info_.defaultFramebuffer ? request.height : 0;
    return {};
}

std::string GlContext::describe() const {
    const bool core = info_.profile == ContextRequest::Profile::Core;
    std::string line = platformName() + ", " + info_.renderer + ", " + std::to_string(info_.major) +
                       "." + std::to_string(info_.minor) + (core ? " core" : " compatibility");
    const std::string driver = driverOf(info_.version);
    return driver.empty() ? line : line + ", " + driver;
}

std::vector<ContextRequest::Api> availableApis() {
    std::vector<ContextRequest::Api> apis{ContextRequest::Api::Egl};
    if (osMesaBuilt()) {
        apis.push_back(ContextRequest::Api::OsMesa);
    }
    if (glfwBuilt()) {
        apis.push_back(ContextRequest::Api::Glfw);
    }
    return apis;
}

Result<std::unique_ptr<GlContext>> createContext(const ContextRequest& request) {
    if (AoStatus status = checkRequest(request); !status.ok()) {
        return status;
    }
    releaseThread(); // GLFW makes a new window's context current to look at it
    auto made = createByApi(request);
    if (!made.ok()) {
        return made;
    }
    if (AoStatus status = (*made)->makeCurrent(); !status.ok()) {
        return status;
    }
    if (AoStatus status = (*made)->readInfo(request); !status.ok()) {
        return status;
    }
    return made;
}

Result<std::unique_ptr<GlContext>> createOffscreenContext(ContextRequest request) {
    request.api = ContextRequest::Api::Egl;
    auto egl = createContext(request);
    if (egl.ok()) {
        return egl;
    }
    request.api = ContextRequest::Api::OsMesa;
    auto osMesa = createContext(request);
    if (osMesa.ok()) {
        return osMesa;
    }
    return AoStatus(egl.status().code(), egl.status().message() + " " + osMesa.status().message());
}

} // namespace aolib
