#include "HostGl.h"

#include <set>
#include <stdexcept>
#include <string>

namespace aolib {

namespace {

constexpr GLenum kMaxTextureCoords = 0x8871;

HostGl::Has inspect(const HostGl& gl, bool newest) {
    std::set<std::string> extensions;
    for (GLint i = 0; i < gl.integer(GL_NUM_EXTENSIONS); ++i) {
        extensions.insert(
            reinterpret_cast<const char*>(gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i))));
    }
    const int version = gl.integer(GL_MAJOR_VERSION) * 10 + gl.integer(GL_MINOR_VERSION);
    const auto since = [&](int number, const char* extension) {
        return newest && (version >= number || extensions.count(extension) != 0);
    };
    constexpr int kNever = 1000;
    HostGl::Has has;
    has.compatibility =
        (gl.integer(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) != 0;
    has.debug = since(43, "GL_KHR_debug");
    has.clipControl = since(45, "GL_ARB_clip_control");
    has.indexedBlend = since(40, "GL_ARB_draw_buffers_blend");
    has.advancedBlend = since(kNever, "GL_KHR_blend_equation_advanced");
    has.viewportArray = since(41, "GL_ARB_viewport_array");
    has.transformFeedback2 = since(40, "GL_ARB_transform_feedback2");
    has.sampleShading = since(40, "GL_ARB_sample_shading");
    has.tessellation = since(40, "GL_ARB_tessellation_shader");
    has.fixedIndexRestart = since(43, "GL_ARB_ES3_compatibility");
    has.separatePrograms = since(41, "GL_ARB_separate_shader_objects");
    has.imageUnits = since(42, "GL_ARB_shader_image_load_store");
    has.atomicCounters = since(42, "GL_ARB_shader_atomic_counters");
    has.shaderStorage = since(43, "GL_ARB_shader_storage_buffer_object");
    has.indirect = since(40, "GL_ARB_draw_indirect");
    has.compute = since(43, "GL_ARB_compute_shader");
    has.queryBuffer = since(44, "GL_ARB_query_buffer_object");
    has.parameterBuffer = since(46, "GL_ARB_indirect_parameters");
    has.vertexBindings = since(43, "GL_ARB_vertex_attrib_binding");
    has.cubeMapArray = since(40, "GL_ARB_texture_cube_map_array");
    has.polygonOffsetClamp = since(46, "GL_ARB_polygon_offset_clamp");
    has.packInvert = since(kNever, "GL_MESA_pack_invert");
    has.conservativeQuery = since(43, "GL_ARB_ES3_compatibility");
    has.textureUnits = gl.integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
    has.coordinateUnits = has.compatibility ? gl.integer(kMaxTextureCoords) : 0;
    has.attributes = gl.integer(GL_MAX_VERTEX_ATTRIBS);
    has.drawBuffers = gl.integer(GL_MAX_DRAW_BUFFERS);
    has.viewports = has.viewportArray ? gl.integer(GL_MAX_VIEWPORTS) : 1;
    has.clipDistances = gl.integer(GL_MAX_CLIP_DISTANCES);
    has.sampleMasks = gl.integer(GL_MAX_SAMPLE_MASK_WORDS);
    has.debugGroups = has.debug ? gl.integer(GL_MAX_DEBUG_GROUP_STACK_DEPTH) : 0;
    return has;
}

} // namespace

GLint HostGl::integer(GLenum name) const {
    GLint value = 0;
    GetIntegerv(name, &value);
    return value;
}

ProcAddressLoader HostGl::withoutNewer(const ProcAddressLoader& loader) {
    static const std::set<std::string> newer{
#define AOLIB_HOST_GL_NAME(type, name) "gl" #name,
        AOLIB_HOST_GL_NEWER(AOLIB_HOST_GL_NAME)
#undef AOLIB_HOST_GL_NAME
    };
    return [loader](const char* name) -> void* {
        return newer.count(name) != 0 ? nullptr : loader(name);
    };
}

HostGl HostGl::load(const ProcAddressLoader& loader, bool newest) {
    HostGl gl;
    std::string missing;
#define AOLIB_HOST_GL_LOAD(type, name)                                                             \
    gl.name = reinterpret_cast<type>(loader("gl" #name));                                          \
    missing += gl.name == nullptr ? " gl" #name : "";
    AOLIB_HOST_GL_CORE(AOLIB_HOST_GL_LOAD)
#undef AOLIB_HOST_GL_LOAD
#define AOLIB_HOST_GL_LOAD(type, name) gl.name = reinterpret_cast<type>(loader("gl" #name));
    AOLIB_HOST_GL_NEWER(AOLIB_HOST_GL_LOAD)
#undef AOLIB_HOST_GL_LOAD
#define AOLIB_HOST_GL_LOAD(name, ...)                                                              \
    gl.name = reinterpret_cast<void(APIENTRY*)(__VA_ARGS__)>(loader("gl" #name));
    AOLIB_HOST_GL_COMPATIBILITY(AOLIB_HOST_GL_LOAD)
#undef AOLIB_HOST_GL_LOAD
    if (!missing.empty()) {
        throw std::runtime_error("the tests' loader does not know" + missing);
    }
    gl.has = inspect(gl, newest);
    return gl;
}

} // namespace aolib
