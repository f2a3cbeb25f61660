#pragma once

namespace aolib {

/// Selects parts of the GL state that aolib neither queries nor restores. Select a part if the host
/// sets it after each call or does not use it: aolib leaves a selected part changed.
/// A frame always queries the state it reads: the draw framebuffer; viewport, depth range and
/// scissor test of viewport 0; sRGB encoding; clip control.
/// By default nothing is selected and everything is restored. Since 0.1.
struct StateTrust {
    bool framebuffers = false; ///< draw and read framebuffer
    bool programs = false;     ///< program (except during transform feedback), vertex array,
                               ///< array buffer
    bool textures = false;     ///< 2D and 2D array textures and samplers of units 0 to 7, active
                               ///< unit
    bool pixels = false;       ///< pixel pack, unpack and query buffer, pixel store and transfer,
                               ///< read colour clamp
    bool depth = false;        ///< depth test, mask, function and clamp, stencil test
    bool blending = false;     ///< blending and colour masks of each draw buffer, logic operation,
                               ///< dithering, alpha test, sRGB encoding
    bool raster = false;       ///< culling, front face, polygon, line and sample state, primitive
                               ///< restart, rasterizer discard, clip distances, clip control
    bool viewports = false;    ///< viewports, depth ranges, scissor tests

    bool operator==(const StateTrust&) const = default;
};

} // namespace aolib
