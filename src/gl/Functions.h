#pragma once

#include <string>

#include "gl/CoreTypes.h"

#include <aolib/ProcAddressLoader.h>
#include <aolib/StateTrust.h>
#include <aolib/Status.h>

#include "gl/FunctionList.h"

namespace aolib::gl {

// Compatibility-profile functions, which the core header does not declare.
using PixelTransferFunction = void(APIENTRY*)(GLenum, GLfloat);

class ContextGroup;
class StateGuard;

/// The GL functions of one context, one table per instance, and what that context can do.
struct Functions {
#define AOLIB_GL_MEMBER(type, name) type name = nullptr;
    AOLIB_GL_REQUIRED(AOLIB_GL_MEMBER)
    AOLIB_GL_OPTIONAL(AOLIB_GL_MEMBER)
#undef AOLIB_GL_MEMBER

    struct Capabilities {
        int version = 0;            ///< major * 10 + minor
        bool compatibility = false; ///< the fixed-function pipeline exists
        bool clipControl = false;   ///< GL 4.5 or ARB_clip_control
        bool indexedBlend = false; ///< GL 4.0 or ARB_draw_buffers_blend: blend functions per buffer
        bool viewportArray = false;     ///< GL 4.1 or ARB_viewport_array
        bool pauseFeedback = false;     ///< GL 4.0 or ARB_transform_feedback2
        bool sampleShading = false;     ///< GL 4.0 or ARB_sample_shading
        bool fixedIndexRestart = false; ///< GL 4.3 or ARB_ES3_compatibility
        bool debug = false;             ///< GL 4.3 or KHR_debug
        bool queryBuffer = false;       ///< GL 4.4 or ARB_query_buffer_object
        bool conservativeQuery = false; ///< GL 4.3 or ARB_ES3_compatibility
        bool packInvert = false;        ///< MESA_pack_invert
        bool software = false; ///< rasterises on the host's own processor, as its name tells
        int maxTextureSize = 0;
        int maxTextureLayers = 0;
        int maxTextureUnits = 0; ///< of all stages together
        int maxDrawBuffers = 0;
        int maxViewports = 1;
        int maxClipDistances = 0;
        int maxDebugGroups = 0; ///< open at a time
    } capabilities;

    /// The contexts that share the objects made by this table; null: there is but one.
    ContextGroup* group = nullptr;
    /// Where the host's state is while calls run; null: nothing is taken aside.
    mutable StateGuard* guard = nullptr;
    bool debugGroups = true; ///< passes are grouped for debuggers
    StateTrust trusted{};    ///< what is neither queried nor restored outside of a StateGuard

    /// Fills the table for the current context.
    /// Errors: NoContext, MissingCapability (older than 3.3, or a function is missing by name).
    static Result<Functions> load(const ProcAddressLoader& loader);
    /// Asks the current context what it can do. Errors: MissingCapability (older than 3.3).
    AoStatus readCapabilities();
};

} // namespace aolib::gl
