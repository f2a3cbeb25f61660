#include "gl/Functions.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <set>
#include <string>

namespace aolib::gl {

namespace {

constexpr int kLeastVersion = 33; // major * 10 + minor

/// wglGetProcAddress returns null, 1, 2, 3 or -1 for a function that the driver does not have.
bool isAddress(const void* address) {
    const auto value = reinterpret_cast<std::intptr_t>(address);
    return value < -1 || value > 3;
}

template <typename Function>
void loadFunction(const ProcAddressLoader& loader, const char* name, Function& function) {
    void* address = loader(name);
    if (!isAddress(address)) {
        return;
    }
    static_assert(sizeof(address) == sizeof(function));
    std::memcpy(&function, &address, sizeof(function));
}

std::set<std::string> extensionsOf(const Functions& gl) {
    GLint count = 0;
    gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
    std::set<std::string> extensions;
    for (GLint i = 0; i < count; ++i) {
        const GLubyte* name = gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
        if (name != nullptr) {
            extensions.insert(reinterpret_cast<const char*>(name));
        }
    }
    return extensions;
}

int integer(const Functions& gl, GLenum name) {
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

/// From the text "4.5 ...": a context older than 3.0 answers GL_MAJOR_VERSION with an error. 0 for
/// what is no desktop GL.
int versionOf(const Functions& gl) {
    const auto* text = reinterpret_cast<const char*>(gl.GetString(GL_VERSION));
    int major = 0;
    int minor = 0;
    return std::sscanf(text, "%d.%d", &major, &minor) == 2 ? major * 10 + minor : 0;
}

/// GL says nothing else of what it runs on.
bool isSoftware(const Functions& gl) {
    const auto* text = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    const std::string name = text != nullptr ? text : "";
    constexpr std::array<const char*, 6> kKnown{"llvmpipe",    "softpipe",    "Software Rasterizer",
                                                "SwiftShader", "GDI Generic", "Basic Render"};
    return std::any_of(kKnown.begin(), kKnown.end(),
                       [&](const char* known) { return name.find(known) != std::string::npos; });
}

Functions::Capabilities capabilitiesOf(const Functions& gl, int version) {
    const std::set<std::string> extensions = extensionsOf(gl);
    const auto has = [&](int since, const char* extension, auto... functions) {
        return (version >= since || extensions.count(extension) != 0) &&
               ((functions != nullptr) && ...);
    };
    Functions::Capabilities can;
    can.version = version;
    can.compatibility =
        (integer(gl, GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0 ||
        (integer(gl, GL_CONTEXT_PROFILE_MASK) == 0 &&
         extensions.count("GL_ARB_compatibility") != 0);
    can.clipControl = has(45, "GL_ARB_clip_control", gl.ClipControl);
    can.indexedBlend = has(40, "GL_ARB_draw_buffers_blend", gl.BlendFuncSeparatei,
                           gl.BlendEquationSeparatei, gl.BlendEquationi);
    can.viewportArray = has(41, "GL_ARB_viewport_array", gl.ViewportIndexedfv, gl.GetFloati_v,
                            gl.DepthRangeIndexed, gl.GetDoublei_v);
    can.pauseFeedback = has(40, "GL_ARB_transform_feedback2", gl.PauseTransformFeedback,
                            gl.ResumeTransformFeedback);
    can.sampleShading = has(40, "GL_ARB_sample_shading", gl.MinSampleShading);
    can.fixedIndexRestart = has(43, "GL_ARB_ES3_compatibility");
    can.debug = has(43, "GL_KHR_debug", gl.ObjectLabel, gl.PushDebugGroup, gl.PopDebugGroup);
    can.conservativeQuery = has(43, "GL_ARB_ES3_compatibility");
    can.packInvert = extensions.count("GL_MESA_pack_invert") != 0;
    can.queryBuffer = has(44, "GL_ARB_query_buffer_object") ||
                      extensions.count("GL_AMD_query_buffer_object") != 0;
    can.software = isSoftware(gl);
    can.maxTextureSize = integer(gl, GL_MAX_TEXTURE_SIZE);
    can.maxTextureLayers = integer(gl, GL_MAX_ARRAY_TEXTURE_LAYERS);
    can.maxTextureUnits = integer(gl, GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    can.maxDrawBuffers = integer(gl, GL_MAX_DRAW_BUFFERS);
    can.maxViewports = can.viewportArray ? integer(gl, GL_MAX_VIEWPORTS) : 1;
    can.maxClipDistances = integer(gl, GL_MAX_CLIP_DISTANCES);
    can.maxDebugGroups = can.debug ? integer(gl, GL_MAX_DEBUG_GROUP_STACK_DEPTH) : 0;
    return can;
}

/// @param missing  names of required functions, with a space before each.
AoStatus missingFunctions(const std::string& missing, bool oldestMissing) {
    std::string reason = "the loader returned no address for" + missing;
    if (oldestMissing) {
        reason += "; if the loader only calls wglGetProcAddress, load functions of OpenGL 1.1 from "
                  "opengl32.dll with GetProcAddress";
    }
    return {StatusCode::MissingCapability, reason};
}

} // namespace

Result<Functions> Functions::load(const ProcAddressLoader& loader) {
    if (!loader) {
        return AoStatus(
            StatusCode::NoContext,
            "the loader is empty; pass a function that returns addresses of GL functions");
    }
    Functions gl;
    std::string missing;
    bool known = false;
#define AOLIB_GL_LOAD_REQUIRED(type, name)                                                         \
    loadFunction(loader, "gl" #name, gl.name);                                                     \
    known = known || gl.name != nullptr;                                                           \
    if (gl.name == nullptr) {                                                                      \
        missing += " gl" #name;                                                                    \
    }
    AOLIB_GL_REQUIRED(AOLIB_GL_LOAD_REQUIRED)
#undef AOLIB_GL_LOAD_REQUIRED
#define AOLIB_GL_LOAD(type, name) loadFunction(loader, "gl" #name, gl.name);
    AOLIB_GL_OPTIONAL(AOLIB_GL_LOAD)
#undef AOLIB_GL_LOAD
    if (!known) {
        return AoStatus(StatusCode::NoContext,
                        "the loader returned no address of any OpenGL function; make a context "
                        "current before create()");
    }
    if (gl.GetString == nullptr || gl.GetIntegerv == nullptr) {
        return missingFunctions(missing, true);
    }
    if (gl.GetString(GL_VERSION) == nullptr) {
        return AoStatus(
            StatusCode::NoContext,
            "glGetString returned no version: no OpenGL context is current, or the loader "
            "belongs to another context");
    }
    if (versionOf(gl) >= kLeastVersion && !missing.empty()) {
        return missingFunctions(missing, false);
    }
    if (AoStatus status = gl.readCapabilities(); !status) {
        return status;
    }
    return gl;
}

AoStatus Functions::readCapabilities() {
    const int version = versionOf(*this);
    if (version < kLeastVersion) {
        return {StatusCode::MissingCapability,
                std::string("OpenGL 3.3 or newer is required; this context has ") +
                    reinterpret_cast<const char*>(GetString(GL_VERSION))};
    }
    capabilities = capabilitiesOf(*this, version);
    return {};
}

} // namespace aolib::gl
