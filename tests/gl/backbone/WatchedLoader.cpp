#include "WatchedLoader.h"

#include <map>

namespace aolib {

namespace {

WatchedLoader* current = nullptr;

const GLubyte* APIENTRY getString(GLenum name) {
    return name == GL_RENDERER && !current->renderer.empty()
               ? reinterpret_cast<const GLubyte*>(current->renderer.c_str())
               : current->getString(name);
}

void APIENTRY drawElements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
    ++current->drawn;
    current->drawElements(mode, count, type, indices);
}

void APIENTRY readPixels(GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                         GLenum type, void* pixels) {
    GLint buffer = 0;
    current->getIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &buffer);
    if (buffer == 0) {
        current->waits.emplace_back("glReadPixels");
    }
    current->readPixels(x, y, width, height, format, type, pixels);
}

GLenum APIENTRY clientWaitSync(GLsync fence, GLbitfield flags, GLuint64 nanoseconds) {
    if (nanoseconds > 0) {
        current->waits.emplace_back("glClientWaitSync");
    } else if (++current->asked[fence] <= WatchedLoader::kEarly) {
        return GL_TIMEOUT_EXPIRED;
    }
    return current->clientWaitSync(fence, flags, nanoseconds);
}

void APIENTRY deleteSync(GLsync fence) {
    current->asked.erase(fence);
    current->deleteSync(fence);
}

void APIENTRY finish() {
    current->waits.emplace_back("glFinish");
    current->finish();
}

} // namespace

WatchedLoader::WatchedLoader(const ProcAddressLoader& real, const std::string& name)
    : renderer(name) {
    const auto load = [&](auto& function, const char* of) {
        function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(real(of));
    };
    load(getString, "glGetString");
    load(getIntegerv, "glGetIntegerv");
    load(drawElements, "glDrawElements");
    load(readPixels, "glReadPixels");
    load(clientWaitSync, "glClientWaitSync");
    load(deleteSync, "glDeleteSync");
    load(finish, "glFinish");
    const std::map<std::string, void*> watched{
        {"glGetString", reinterpret_cast<void*>(&aolib::getString)},
        {"glDrawElements", reinterpret_cast<void*>(&aolib::drawElements)},
        {"glReadPixels", reinterpret_cast<void*>(&aolib::readPixels)},
        {"glClientWaitSync", reinterpret_cast<void*>(&aolib::clientWaitSync)},
        {"glDeleteSync", reinterpret_cast<void*>(&aolib::deleteSync)},
        {"glFinish", reinterpret_cast<void*>(&aolib::finish)}};
    loader_ = [real, watched](const char* of) {
        const auto found = watched.find(of);
        return found != watched.end() ? found->second : real(of);
    };
    current = this;
}

WatchedLoader::~WatchedLoader() {
    current = nullptr;
}

} // namespace aolib
