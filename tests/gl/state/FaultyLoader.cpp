#include "FaultyLoader.h"

#include <algorithm>
#include <array>

namespace aolib {

namespace {

FaultyLoader* current = nullptr;

// ---- Names ------------------------------------------------------------------------------------

/// A name that is part of a type: which function, which kind of object.
template <std::size_t N>
struct Text {
    char value[N]{};
    constexpr Text(const char (&text)[N]) { std::copy_n(text, N, value); }
};

template <Text Function, Text Kind, Fault Refusal>
void APIENTRY generate(GLsizei count, GLuint* names) {
    if (current->fails(Refusal)) {
        std::fill_n(names, count, 0U);
        return;
    }
    current->real<PFNGLGENTEXTURESPROC>(Function.value)(count, names);
    current->ledger[Kind.value].insert(names, names + count);
}

template <Text Function, Text Kind>
void APIENTRY remove(GLsizei count, const GLuint* names) {
    current->real<PFNGLDELETETEXTURESPROC>(Function.value)(count, names);
    for (GLsizei i = 0; i < count; ++i) {
        current->ledger[Kind.value].erase(names[i]);
    }
}

GLuint APIENTRY createShader(GLenum kind) {
    if (current->fails(Fault::CreateShader)) {
        return 0;
    }
    const GLuint name = current->real<PFNGLCREATESHADERPROC>("glCreateShader")(kind);
    current->ledger["shaders"].insert(name);
    return name;
}
void APIENTRY deleteShader(GLuint name) {
    current->real<PFNGLDELETESHADERPROC>("glDeleteShader")(name);
    current->ledger["shaders"].erase(name);
}
GLuint APIENTRY createProgram() {
    if (current->fails(Fault::CreateProgram)) {
        return 0;
    }
    const GLuint name = current->real<PFNGLCREATEPROGRAMPROC>("glCreateProgram")();
    current->ledger["programs"].insert(name);
    return name;
}
void APIENTRY deleteProgram(GLuint name) {
    current->real<PFNGLDELETEPROGRAMPROC>("glDeleteProgram")(name);
    current->ledger["programs"].erase(name);
}
GLsync APIENTRY fenceSync(GLenum condition, GLbitfield flags) {
    if (current->fails(Fault::FenceSync)) {
        return nullptr;
    }
    GLsync fence = current->real<PFNGLFENCESYNCPROC>("glFenceSync")(condition, flags);
    current->ledger["fences"].insert(reinterpret_cast<std::uintptr_t>(fence));
    return fence;
}
void APIENTRY deleteSync(GLsync fence) {
    current->real<PFNGLDELETESYNCPROC>("glDeleteSync")(fence);
    current->ledger["fences"].erase(reinterpret_cast<std::uintptr_t>(fence));
}

void APIENTRY queryCounter(GLuint name, GLenum target) {
    current->real<PFNGLQUERYCOUNTERPROC>("glQueryCounter")(name, target);
    ++current->timestamps;
}

// ---- Answers ----------------------------------------------------------------------------------

void APIENTRY getShaderiv(GLuint name, GLenum query, GLint* value) {
    current->real<PFNGLGETSHADERIVPROC>("glGetShaderiv")(name, query, value);
    if (query == GL_COMPILE_STATUS && current->fails(Fault::CompileShader)) {
        *value = GL_FALSE;
    }
}
void APIENTRY getProgramiv(GLuint name, GLenum query, GLint* value) {
    current->real<PFNGLGETPROGRAMIVPROC>("glGetProgramiv")(name, query, value);
    if (query == GL_LINK_STATUS && current->fails(Fault::LinkProgram)) {
        *value = GL_FALSE;
    }
}
GLenum APIENTRY checkFramebufferStatus(GLenum target) {
    return current->fails(Fault::FramebufferStatus)
               ? GL_FRAMEBUFFER_UNSUPPORTED
               : current->real<PFNGLCHECKFRAMEBUFFERSTATUSPROC>("glCheckFramebufferStatus")(target);
}
void APIENTRY texImage2D(GLenum target, GLint level, GLint internalFormat, GLsizei width,
                         GLsizei height, GLint border, GLenum format, GLenum type,
                         const void* data) {
    if (!current->fails(Fault::TextureStorage)) {
        current->real<PFNGLTEXIMAGE2DPROC>("glTexImage2D")(target, level, internalFormat, width,
                                                           height, border, format, type, data);
    }
}
void APIENTRY texImage3D(GLenum target, GLint level, GLint internalFormat, GLsizei width,
                         GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type,
                         const void* data) {
    if (!current->fails(Fault::TextureStorage)) {
        current->real<PFNGLTEXIMAGE3DPROC>("glTexImage3D")(
            target, level, internalFormat, width, height, depth, border, format, type, data);
    }
}
void APIENTRY getTexLevelParameteriv(GLenum target, GLint level, GLenum query, GLint* value) {
    current->real<PFNGLGETTEXLEVELPARAMETERIVPROC>("glGetTexLevelParameteriv")(target, level, query,
                                                                               value);
    if (current->fails(Fault::TextureSize)) {
        *value = 0;
    }
}
void APIENTRY bufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
    if (!current->fails(Fault::BufferStorage)) {
        current->real<PFNGLBUFFERDATAPROC>("glBufferData")(target, size, data, usage);
    }
}
void* APIENTRY mapBufferRange(GLenum target, GLintptr offset, GLsizeiptr size, GLbitfield access) {
    return current->fails(Fault::MapBuffer) ? nullptr
                                            : current->real<PFNGLMAPBUFFERRANGEPROC>(
                                                  "glMapBufferRange")(target, offset, size, access);
}

template <typename Function>
void* address(Function function) {
    return reinterpret_cast<void*>(function);
}

const std::map<std::string, void*>& replacements() {
    static const std::map<std::string, void*> table{
        {"glGenTextures", address(&generate<"glGenTextures", "textures", Fault::GenTextures>)},
        {"glGenBuffers", address(&generate<"glGenBuffers", "buffers", Fault::GenBuffers>)},
        {"glGenFramebuffers",
         address(&generate<"glGenFramebuffers", "framebuffers", Fault::GenFramebuffers>)},
        {"glGenVertexArrays",
         address(&generate<"glGenVertexArrays", "vertex arrays", Fault::GenVertexArrays>)},
        {"glGenQueries", address(&generate<"glGenQueries", "queries", Fault::GenQueries>)},
        {"glDeleteTextures", address(&remove<"glDeleteTextures", "textures">)},
        {"glDeleteBuffers", address(&remove<"glDeleteBuffers", "buffers">)},
        {"glDeleteFramebuffers", address(&remove<"glDeleteFramebuffers", "framebuffers">)},
        {"glDeleteVertexArrays", address(&remove<"glDeleteVertexArrays", "vertex arrays">)},
        {"glDeleteQueries", address(&remove<"glDeleteQueries", "queries">)},
        {"glCreateShader", address(&createShader)},
        {"glDeleteShader", address(&deleteShader)},
        {"glCreateProgram", address(&createProgram)},
        {"glDeleteProgram", address(&deleteProgram)},
        {"glFenceSync", address(&fenceSync)},
        {"glDeleteSync", address(&deleteSync)},
        {"glQueryCounter", address(&queryCounter)},
        {"glGetShaderiv", address(&getShaderiv)},
        {"glGetProgramiv", address(&getProgramiv)},
        {"glCheckFramebufferStatus", address(&checkFramebufferStatus)},
        {"glTexImage2D", address(&texImage2D)},
        {"glTexImage3D", address(&texImage3D)},
        {"glGetTexLevelParameteriv", address(&getTexLevelParameteriv)},
        {"glBufferData", address(&bufferData)},
        {"glMapBufferRange", address(&mapBufferRange)}};
    return table;
}

} // namespace

const char* faultName(Fault fault) {
    constexpr std::array<const char*, kFaults> names{
        "GenTextures",   "GenBuffers",        "GenFramebuffers", "GenVertexArrays",
        "GenQueries",    "CreateShader",      "CreateProgram",   "CompileShader",
        "LinkProgram",   "FramebufferStatus", "TextureStorage",  "TextureSize",
        "BufferStorage", "FenceSync",         "MapBuffer"};
    return names[static_cast<std::size_t>(fault)];
}

FaultyLoader::FaultyLoader(const ProcAddressLoader& real) {
    current = this;
    for (const auto& [name, function] : replacements()) {
        functions_[name] = real(name.c_str());
    }
    loader_ = [real](const char* name) -> void* {
        const auto found = replacements().find(name);
        return found == replacements().end() ? real(name) : found->second;
    };
}

FaultyLoader::~FaultyLoader() {
    current = nullptr;
}

void FaultyLoader::failAt(Fault fault, int n) {
    fault_ = fault;
    countdown_ = n;
    failed_ = false;
}

bool FaultyLoader::fails(Fault fault) {
    if (countdown_ == 0 || fault != fault_ || --countdown_ > 0) {
        return false;
    }
    failed_ = true;
    return true;
}

std::string FaultyLoader::alive() const {
    std::string text;
    for (const auto& [kind, names] : ledger) {
        if (!names.empty()) {
            text.append(text.empty() ? "" : "; ").append(kind);
            for (const std::uintptr_t name : names) {
                text.append(" ").append(std::to_string(name));
            }
        }
    }
    return text;
}

} // namespace aolib
