#include "platform/DebugLog.h"

#include <GL/glcorearb.h>

#include <array>
#include <string_view>
#include <utility>

namespace aolib {

/// The messages, at an address that the driver may keep, and the way back.
struct DebugLog::Slot {
    std::vector<Message> messages;
    PFNGLDEBUGMESSAGECALLBACKPROC setCallback = nullptr;
    PFNGLENABLEPROC enable = nullptr;
    PFNGLDISABLEPROC disable = nullptr;
    GLDEBUGPROC previousCallback = nullptr;
    void* previousUser = nullptr;
    bool outputWasOn = false;
    bool synchronousWasOn = false;
};

namespace {

DebugLog::Severity severityOf(GLenum severity) {
    switch (severity) {
    case GL_DEBUG_SEVERITY_HIGH:
        return DebugLog::Severity::High;
    case GL_DEBUG_SEVERITY_MEDIUM:
        return DebugLog::Severity::Medium;
    default:
        return DebugLog::Severity::Low;
    }
}

void APIENTRY collect(GLenum, GLenum type, GLuint id, GLenum severity, GLsizei length,
                      const GLchar* text, const void* user) {
    if (severity == GL_DEBUG_SEVERITY_NOTIFICATION) {
        return;
    }
    auto* messages = static_cast<std::vector<DebugLog::Message>*>(const_cast<void*>(user));
    const bool error = type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR;
    std::string words =
        length < 0 ? std::string(text) : std::string(text, static_cast<std::size_t>(length));
    while (!words.empty() && (words.back() == '\n' || words.back() == '\0')) {
        words.pop_back();
    }
    messages->push_back({severityOf(severity), error, id, std::move(words)});
}

bool hasDebug(PFNGLGETINTEGERVPROC getIntegerv, PFNGLGETSTRINGIPROC getStringi) {
    GLint major = 0;
    GLint minor = 0;
    getIntegerv(GL_MAJOR_VERSION, &major);
    getIntegerv(GL_MINOR_VERSION, &minor);
    if (major > 4 || (major == 4 && minor >= 3)) {
        return true;
    }
    GLint count = 0;
    getIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLuint i = 0; getStringi != nullptr && i < static_cast<GLuint>(count); ++i) {
        const GLubyte* name = getStringi(GL_EXTENSIONS, i);
        if (name != nullptr &&
            std::string_view(reinterpret_cast<const char*>(name)) == "GL_KHR_debug") {
            return true;
        }
    }
    return false;
}

} // namespace

Result<std::unique_ptr<DebugLog>> DebugLog::install(const ProcAddressLoader& loader) {
    const auto getIntegerv = reinterpret_cast<PFNGLGETINTEGERVPROC>(loader("glGetIntegerv"));
    const auto isEnabled = reinterpret_cast<PFNGLISENABLEDPROC>(loader("glIsEnabled"));
    const auto getPointerv = reinterpret_cast<PFNGLGETPOINTERVPROC>(loader("glGetPointerv"));
    const auto control =
        reinterpret_cast<PFNGLDEBUGMESSAGECONTROLPROC>(loader("glDebugMessageControl"));
    auto slot = std::make_unique<Slot>();
    slot->setCallback =
        reinterpret_cast<PFNGLDEBUGMESSAGECALLBACKPROC>(loader("glDebugMessageCallback"));
    slot->enable = reinterpret_cast<PFNGLENABLEPROC>(loader("glEnable"));
    slot->disable = reinterpret_cast<PFNGLDISABLEPROC>(loader("glDisable"));
    if (getIntegerv == nullptr || isEnabled == nullptr || slot->enable == nullptr ||
        slot->disable == nullptr) {
        return AoStatus(StatusCode::NoContext,
                        "The loader does not know glGetIntegerv, glIsEnabled, "
                        "glEnable and glDisable.");
    }
    const auto getStringi = reinterpret_cast<PFNGLGETSTRINGIPROC>(loader("glGetStringi"));
    if (slot->setCallback == nullptr || control == nullptr || getPointerv == nullptr ||
        !hasDebug(getIntegerv, getStringi)) {
        return AoStatus(StatusCode::MissingCapability,
                        "The context has neither OpenGL 4.3 nor GL_KHR_debug.");
    }
    slot->outputWasOn = isEnabled(GL_DEBUG_OUTPUT) == GL_TRUE;
    slot->synchronousWasOn = isEnabled(GL_DEBUG_OUTPUT_SYNCHRONOUS) == GL_TRUE;
    void* callback = nullptr;
    getPointerv(GL_DEBUG_CALLBACK_FUNCTION, &callback);
    getPointerv(GL_DEBUG_CALLBACK_USER_PARAM, &slot->previousUser);
    slot->previousCallback = reinterpret_cast<GLDEBUGPROC>(callback);

    slot->enable(GL_DEBUG_OUTPUT);
    slot->enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    constexpr std::array<GLenum, 3> wanted{GL_DEBUG_SEVERITY_HIGH, GL_DEBUG_SEVERITY_MEDIUM,
                                           GL_DEBUG_SEVERITY_LOW};
    for (const GLenum severity : wanted) {
        control(GL_DONT_CARE, GL_DONT_CARE, severity, 0, nullptr, GL_TRUE);
    }
    slot->setCallback(collect, &slot->messages);
    return std::unique_ptr<DebugLog>(new DebugLog(std::move(slot)));
}

DebugLog::DebugLog(std::unique_ptr<Slot> slot) : slot_(std::move(slot)) {}

DebugLog::~DebugLog() {
    slot_->setCallback(slot_->previousCallback, slot_->previousUser);
    if (!slot_->outputWasOn) {
        slot_->disable(GL_DEBUG_OUTPUT);
    }
    if (!slot_->synchronousWasOn) {
        slot_->disable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    }
}

bool DebugLog::empty() const {
    return slot_->messages.empty();
}

const std::vector<DebugLog::Message>& DebugLog::messages() const {
    return slot_->messages;
}

void DebugLog::clear() {
    slot_->messages.clear();
}

std::string DebugLog::text() const {
    std::string lines;
    for (const Message& message : slot_->messages) {
        const char* severity = message.severity == Severity::High     ? "high"
                               : message.severity == Severity::Medium ? "medium"
                                                                      : "low";
        lines += std::string(severity) + (message.error ? " error " : " message ") +
                 std::to_string(message.id) + ": " + message.text + "\n";
    }
    return lines;
}

} // namespace aolib
