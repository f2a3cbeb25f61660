#pragma once

#include <initializer_list>

#include <GL/glcorearb.h>

#include <aolib/ProcAddressLoader.h>

#include "HostGlList.h"

namespace aolib {

using GLenums = std::initializer_list<GLenum>;

/// The host's own GL functions: loaded here, apart from aolib's table, so that the tests share
/// neither its lists nor its mistakes.
struct HostGl {
#define AOLIB_HOST_GL_MEMBER(type, name) type name = nullptr;
    AOLIB_HOST_GL_CORE(AOLIB_HOST_GL_MEMBER)
    AOLIB_HOST_GL_NEWER(AOLIB_HOST_GL_MEMBER)
#undef AOLIB_HOST_GL_MEMBER
#define AOLIB_HOST_GL_MEMBER(name, ...) void(APIENTRY * name)(__VA_ARGS__) = nullptr;
    AOLIB_HOST_GL_COMPATIBILITY(AOLIB_HOST_GL_MEMBER)
#undef AOLIB_HOST_GL_MEMBER

    /// What the context has beyond GL 3.3 core, and its sizes.
    struct Has {
        bool compatibility = false;
        bool debug = false;
        bool clipControl = false;
        bool indexedBlend = false;
        bool advancedBlend = false;
        bool viewportArray = false;
        bool transformFeedback2 = false;
        bool sampleShading = false;
        bool tessellation = false;
        bool fixedIndexRestart = false;
        bool separatePrograms = false;
        bool imageUnits = false;
        bool atomicCounters = false;
        bool shaderStorage = false;
        bool indirect = false;
        bool compute = false;
        bool queryBuffer = false;
        bool parameterBuffer = false;
        bool vertexBindings = false;
        bool cubeMapArray = false;
        bool polygonOffsetClamp = false;
        bool packInvert = false;
        bool conservativeQuery = false;
        int textureUnits = 0;
        int coordinateUnits = 0; ///< of the fixed-function pipeline
        int attributes = 0;
        int drawBuffers = 0;
        int viewports = 1;
        int clipDistances = 0;
        int sampleMasks = 0;
        int debugGroups = 0;
    } has;

    /// Fills the table for the current context. Throws std::runtime_error naming what is missing.
    /// @param newest  else the host knows nothing beyond GL 3.3.
    static HostGl load(const ProcAddressLoader& loader, bool newest = true);
    /// A loader that does not know the functions that came after GL 3.3.
    static ProcAddressLoader withoutNewer(const ProcAddressLoader& loader);

    GLint integer(GLenum name) const;
};

} // namespace aolib
