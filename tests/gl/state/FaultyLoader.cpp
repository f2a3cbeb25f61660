#include "FaultyLoader.h"

#include <algorithm>
#include <array>

namespace aolib {

namespace {

FaultyLoader* inUse = nullptr;

// ---- Names ------------------------------------------------------------------------------------

/// A name that is part of a type: which function, which kind of object.
template <std::size_t N>
struct Text {
    char value[N]{};
    constexpr Text(const char (&text)[N]) { std::copy_n(text, N, value); }
};

template <Text Function, Text Kind, Fault Refusal>
void APIENTRY generate(GLsizei count, GLuint* names) {
    if (inUse->fails(Refusal)) {
        std::fill_n(names, count, 0U);
        return;
    }
    inUse->real<PFNGLGENTEXTURESPROC>(Function.value)(count, names);
    inUse->ledger[Kind.value].insert(names, names + count);
}

template <Text Function, Text Kind>
void APIENTRY remove(GLsizei count, const GLuint* names) {
    inUse->real<PFNGLDELETETEXTURESPROC>(Function.value)(count, names);
    for (GLsizei i = 0; i < count; ++i) {
        inUse->ledger[Kind.value].erase(names[i]);
    }
}

GLuint APIENTRY createShader(GLenum kind) {
    if (inUse->fails(Fault::CreateShader)) {
        return 0;
    }
    const GLuint name = inUse->real<PFNGLCREATESHADERPROC>("glCreateShader")(kind);
    inUse->ledger["shaders"].insert(name);
    return name;
}
void APIENTRY deleteShader(GLuint name) {
    inUse->real<PFNGLDELETESHADERPROC>("glDeleteShader")(name);
    inUse->ledger["shaders"].erase(name);
}
GLuint APIENTRY createProgram() {
    if (inUse->fails(Fault::CreateProgram)) {
        return 0;
    }
    const GLuint name = inUse->real<PFNGLCREATEPROGRAMPROC>("glCreateProgram")();
    inUse->ledger["programs"].insert(name);
    return name;
}
void APIENTRY deleteProgram(GLuint name) {
    inUse->real<PFNGLDELETEPROGRAMPROC>("glDeleteProgram")(name);
    inUse->ledger["programs"].erase(name);
}
GLsync APIENTRY fenceSync(GLenum condition, GLbitfield flags) {
    if (inUse->fails(Fault::FenceSync)) {
        return nullptr;
    }
    GLsync fence = inUse->real<PFNGLFENCESYNCPROC>("glFenceSync")(condition, flags);
    inUse->ledger["fences"].insert(reinterpret_cast<std::uintptr_t>(fence));
    return fence;
}
void APIENTRY deleteSync(GLsync fence) {
    inUse->real<PFNGLDELETESYNCPROC>("glDeleteSync")(fence);
    inUse->ledger["fences"].erase(reinterpret_cast<std::uintptr_t>(fence));
}

void APIENTRY queryCounter(GLuint name, GLenum target) {
    inUse->real<PFNGLQUERYCOUNTERPROC>("glQueryCounter")(name, target);
    ++inUse->timestamps;
}

// ---- Answers ----------------------------------------------------------------------------------

void APIENTRY getShaderiv(GLuint name, GLenum query, GLint* value) {
    inUse->real<PFNGLGETSHADERIVPROC>("glGetShaderiv")(name, query, value);
    if (query == GL_COMPILE_STATUS && inUse->fails(Fault::CompileShader)) {
        *value = GL_FALSE;
    }
}
void APIENTRY getProgramiv(GLuint name, GLenum query, GLint* value) {
    inUse->real<PFNGLGETPROGRAMIVPROC>("glGetProgramiv")(name, query, value);
    if (query == GL_LINK_STATUS && inUse->fails(Fault::LinkProgram)) {
        *value = GL_FALSE;
    }
}
GLenum APIENTRY checkFramebufferStatus(GLenum target) {
    return inUse->fails(Fault::FramebufferStatus)
               ? GL_FRAMEBUFFER_UNSUPPORTED
               : inUse->real<PFNGLCHECKFRAMEBUFFERSTATUSPROC>("glCheckFramebufferStatus")(target);
}
void APIENTRY texImage2D(GLenum target, GLint level, GLint internalFormat, GLsizei width,
                         GLsizei height, GLint border, GLenum format, GLenum type,
                         const void* data) {
    if (!inUse->fails(Fault::TextureStorage)) {
        inUse->real<PFNGLTEXIMAGE2DPROC>("glTexImage2D")(target, level, internalFormat, width,
                                                         height, border, format, type, data);
    }
}
void APIENTRY texImage2DMultisample(GLenum target, GLsizei samples, GLenum internalFormat,
                                    GLsizei width, GLsizei height, GLboolean fixedPlaces) {
    if (!inUse->fails(Fault::TextureStorage)) {
        inUse->real<PFNGLTEXIMAGE2DMULTISAMPLEPROC>("glTexImage2DMultisample")(
            target, samples, internalFormat, width, height, fixedPlaces);
    }
}
void APIENTRY texImage3D(GLenum target, GLint level, GLint internalFormat, GLsizei width,
                         GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type,
                         const void* data) {
    if (!inUse->fails(Fault::TextureStorage)) {
        inUse->real<PFNGLTEXIMAGE3DPROC>("glTexImage3D")(target, level, internalFormat, width,
                                                         height, depth, border, format, type, data);
    }
}
void APIENTRY getTexLevelParameteriv(GLenum target, GLint level, GLenum query, GLint* value) {
    inUse->real<PFNGLGETTEXLEVELPARAMETERIVPROC>("glGetTexLevelParameteriv")(target, level, query,
                                                                             value);
    if (inUse->fails(Fault::TextureSize)) {
        *value = 0;
    }
}
void APIENTRY bufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
    if (!inUse->fails(Fault::BufferStorage)) {
        inUse->real<PFNGLBUFFERDATAPROC>("glBufferData")(target, size, data, usage);
    }
}
void* APIENTRY mapBufferRange(GLenum target, GLintptr offset, GLsizeiptr size, GLbitfield access) {
    return inUse->fails(Fault::MapBuffer) ? nullptr
                                          : inUse->real<PFNGLMAPBUFFERRANGEPROC>(
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
        {"glTexImage2DMultisample", address(&texImage2DMultisample)},
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
    inUse = this;
    for (const auto& [name, function] : replacements()) {
        functions_[name] = real(name.c_str());
    }
    loader_ = [real](const char* name) -> void* {
        const auto found = replacements().find(name);
        return found == replacements().end() ? real(name) : found->second;
    };
}

FaultyLoader::~FaultyLoader() {
    inUse = nullptr;
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
