// Switches, numbers, and state that comes in arrays.
#include <array>

#include "HostState.h"

#define AOLIB_NAMED(name) #name, name

namespace aolib {

void HostState::recordSwitches(StateRecorder& to) const {
    const auto on = [&](const char* name, GLenum query) { to.value(name, gl_.IsEnabled(query)); };
    on(AOLIB_NAMED(GL_COLOR_LOGIC_OP));
    on(AOLIB_NAMED(GL_CULL_FACE));
    on(AOLIB_NAMED(GL_DEPTH_CLAMP));
    on(AOLIB_NAMED(GL_DEPTH_TEST));
    on(AOLIB_NAMED(GL_DITHER));
    on(AOLIB_NAMED(GL_FRAMEBUFFER_SRGB));
    on(AOLIB_NAMED(GL_LINE_SMOOTH));
    on(AOLIB_NAMED(GL_MULTISAMPLE));
    on(AOLIB_NAMED(GL_POLYGON_OFFSET_FILL));
    on(AOLIB_NAMED(GL_POLYGON_OFFSET_LINE));
    on(AOLIB_NAMED(GL_POLYGON_OFFSET_POINT));
    on(AOLIB_NAMED(GL_POLYGON_SMOOTH));
    on(AOLIB_NAMED(GL_PRIMITIVE_RESTART));
    on(AOLIB_NAMED(GL_PROGRAM_POINT_SIZE));
    on(AOLIB_NAMED(GL_RASTERIZER_DISCARD));
    on(AOLIB_NAMED(GL_SAMPLE_ALPHA_TO_COVERAGE));
    on(AOLIB_NAMED(GL_SAMPLE_ALPHA_TO_ONE));
    on(AOLIB_NAMED(GL_SAMPLE_COVERAGE));
    on(AOLIB_NAMED(GL_SAMPLE_MASK));
    on(AOLIB_NAMED(GL_STENCIL_TEST));
    on(AOLIB_NAMED(GL_TEXTURE_CUBE_MAP_SEAMLESS));
    if (gl_.has.fixedIndexRestart) {
        on(AOLIB_NAMED(GL_PRIMITIVE_RESTART_FIXED_INDEX));
    }
    if (gl_.has.sampleShading) {
        on(AOLIB_NAMED(GL_SAMPLE_SHADING));
    }
    if (gl_.has.advancedBlend) {
        on(AOLIB_NAMED(GL_BLEND_ADVANCED_COHERENT_KHR));
    }
    if (gl_.has.debug) {
        on(AOLIB_NAMED(GL_DEBUG_OUTPUT));
        on(AOLIB_NAMED(GL_DEBUG_OUTPUT_SYNCHRONOUS));
    }
    for (int i = 0; i < gl_.has.clipDistances; ++i) {
        to.value("GL_CLIP_DISTANCE", static_cast<std::size_t>(i),
                 gl_.IsEnabled(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i)));
    }
}

void HostState::recordNumbers(StateRecorder& to) const {
    const auto number = [&](const char* name, GLenum query, int count = 1) {
        integers(to, name, query, count);
    };
    const auto real = [&](const char* name, GLenum query, int count = 1) {
        floats(to, name, query, count);
    };
    for (const auto& [name, query] : NamedQueries{{AOLIB_NAMED(GL_CULL_FACE_MODE)},
                                                  {AOLIB_NAMED(GL_DEPTH_FUNC)},
                                                  {AOLIB_NAMED(GL_DEPTH_WRITEMASK)},
                                                  {AOLIB_NAMED(GL_FRONT_FACE)},
                                                  {AOLIB_NAMED(GL_LOGIC_OP_MODE)},
                                                  {AOLIB_NAMED(GL_PROVOKING_VERTEX)},
                                                  {AOLIB_NAMED(GL_CLAMP_READ_COLOR)},
                                                  {AOLIB_NAMED(GL_PRIMITIVE_RESTART_INDEX)},
                                                  {AOLIB_NAMED(GL_POINT_SPRITE_COORD_ORIGIN)},
                                                  {AOLIB_NAMED(GL_SAMPLE_COVERAGE_INVERT)},
                                                  {AOLIB_NAMED(GL_LINE_SMOOTH_HINT)},
                                                  {AOLIB_NAMED(GL_POLYGON_SMOOTH_HINT)},
                                                  {AOLIB_NAMED(GL_TEXTURE_COMPRESSION_HINT)},
                                                  {AOLIB_NAMED(GL_FRAGMENT_SHADER_DERIVATIVE_HINT)},
                                                  {AOLIB_NAMED(GL_STENCIL_CLEAR_VALUE)},
                                                  {AOLIB_NAMED(GL_STENCIL_FUNC)},
                                                  {AOLIB_NAMED(GL_STENCIL_REF)},
                                                  {AOLIB_NAMED(GL_STENCIL_VALUE_MASK)},
                                                  {AOLIB_NAMED(GL_STENCIL_WRITEMASK)},
                                                  {AOLIB_NAMED(GL_STENCIL_FAIL)},
                                                  {AOLIB_NAMED(GL_STENCIL_PASS_DEPTH_FAIL)},
                                                  {AOLIB_NAMED(GL_STENCIL_PASS_DEPTH_PASS)},
                                                  {AOLIB_NAMED(GL_STENCIL_BACK_FUNC)},
                                                  {AOLIB_NAMED(GL_STENCIL_BACK_REF)},
                                                  {AOLIB_NAMED(GL_STENCIL_BACK_VALUE_MASK)},
                                                  {AOLIB_NAMED(GL_STENCIL_BACK_WRITEMASK)},
                                                  {AOLIB_NAMED(GL_STENCIL_BACK_FAIL)},
                                                  {AOLIB_NAMED(GL_STENCIL_BACK_PASS_DEPTH_FAIL)},
                                                  {AOLIB_NAMED(GL_STENCIL_BACK_PASS_DEPTH_PASS)},
                                                  {AOLIB_NAMED(GL_PACK_ALIGNMENT)},
                                                  {AOLIB_NAMED(GL_PACK_IMAGE_HEIGHT)},
                                                  {AOLIB_NAMED(GL_PACK_LSB_FIRST)},
                                                  {AOLIB_NAMED(GL_PACK_ROW_LENGTH)},
                                                  {AOLIB_NAMED(GL_PACK_SKIP_IMAGES)},
                                                  {AOLIB_NAMED(GL_PACK_SKIP_PIXELS)},
                                                  {AOLIB_NAMED(GL_PACK_SKIP_ROWS)},
                                                  {AOLIB_NAMED(GL_PACK_SWAP_BYTES)},
                                                  {AOLIB_NAMED(GL_UNPACK_ALIGNMENT)},
                                                  {AOLIB_NAMED(GL_UNPACK_IMAGE_HEIGHT)},
                                                  {AOLIB_NAMED(GL_UNPACK_LSB_FIRST)},
                                                  {AOLIB_NAMED(GL_UNPACK_ROW_LENGTH)},
                                                  {AOLIB_NAMED(GL_UNPACK_SKIP_IMAGES)},
                                                  {AOLIB_NAMED(GL_UNPACK_SKIP_PIXELS)},
                                                  {AOLIB_NAMED(GL_UNPACK_SKIP_ROWS)},
                                                  {AOLIB_NAMED(GL_UNPACK_SWAP_BYTES)}}) {
        number(name, query);
    }
    number(AOLIB_NAMED(GL_POLYGON_MODE), gl_.has.compatibility ? 2 : 1);
    for (const auto& [name, query] : NamedQueries{{AOLIB_NAMED(GL_LINE_WIDTH)},
                                                  {AOLIB_NAMED(GL_POINT_SIZE)},
                                                  {AOLIB_NAMED(GL_POINT_FADE_THRESHOLD_SIZE)},
                                                  {AOLIB_NAMED(GL_POLYGON_OFFSET_FACTOR)},
                                                  {AOLIB_NAMED(GL_POLYGON_OFFSET_UNITS)},
                                                  {AOLIB_NAMED(GL_SAMPLE_COVERAGE_VALUE)},
                                                  {AOLIB_NAMED(GL_DEPTH_CLEAR_VALUE)}}) {
        real(name, query);
    }
    real(AOLIB_NAMED(GL_BLEND_COLOR), 4);
    real(AOLIB_NAMED(GL_COLOR_CLEAR_VALUE), 4);
    if (gl_.has.clipControl) {
        number(AOLIB_NAMED(GL_CLIP_ORIGIN));
        number(AOLIB_NAMED(GL_CLIP_DEPTH_MODE));
    }
    if (gl_.has.sampleShading) {
        real(AOLIB_NAMED(GL_MIN_SAMPLE_SHADING_VALUE));
    }
    if (gl_.has.tessellation) {
        number(AOLIB_NAMED(GL_PATCH_VERTICES));
        real(AOLIB_NAMED(GL_PATCH_DEFAULT_INNER_LEVEL), 2);
        real(AOLIB_NAMED(GL_PATCH_DEFAULT_OUTER_LEVEL), 4);
    }
    if (gl_.has.polygonOffsetClamp) {
        real(AOLIB_NAMED(GL_POLYGON_OFFSET_CLAMP));
    }
    if (gl_.has.packInvert) {
        constexpr GLenum kPackInvert = 0x8758;
        number("GL_PACK_INVERT_MESA", kPackInvert);
    }
}

void HostState::recordArrays(StateRecorder& to) const {
    std::array<GLint, 4> box{};
    std::array<GLdouble, 2> range{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(gl_.has.viewports); ++i) {
        const auto index = static_cast<GLuint>(i);
        std::array<GLfloat, 4> viewport{};
        if (gl_.has.viewportArray) {
            gl_.GetFloati_v(GL_VIEWPORT, index, viewport.data());
            gl_.GetIntegeri_v(GL_SCISSOR_BOX, index, box.data());
            gl_.GetDoublei_v(GL_DEPTH_RANGE, index, range.data());
            to.value("GL_SCISSOR_TEST", i, gl_.IsEnabledi(GL_SCISSOR_TEST, index));
        } else {
            gl_.GetFloatv(GL_VIEWPORT, viewport.data());
            gl_.GetIntegerv(GL_SCISSOR_BOX, box.data());
            gl_.GetDoublev(GL_DEPTH_RANGE, range.data());
            to.value("GL_SCISSOR_TEST", i, gl_.IsEnabled(GL_SCISSOR_TEST));
        }
        to.values("GL_VIEWPORT", i, viewport.data(), 4);
        to.values("GL_SCISSOR_BOX", i, box.data(), 4);
        to.values("GL_DEPTH_RANGE", i, range.data(), 2);
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(gl_.has.drawBuffers); ++i) {
        const auto index = static_cast<GLuint>(i);
        std::array<GLboolean, 4> mask{};
        gl_.GetBooleani_v(GL_COLOR_WRITEMASK, index, mask.data());
        to.values("GL_COLOR_WRITEMASK", i, mask.data(), 4);
        to.value("GL_BLEND", i, gl_.IsEnabledi(GL_BLEND, index));
        for (const auto& [name, query] : NamedQueries{{AOLIB_NAMED(GL_BLEND_SRC_RGB)},
                                                      {AOLIB_NAMED(GL_BLEND_DST_RGB)},
                                                      {AOLIB_NAMED(GL_BLEND_SRC_ALPHA)},
                                                      {AOLIB_NAMED(GL_BLEND_DST_ALPHA)},
                                                      {AOLIB_NAMED(GL_BLEND_EQUATION_RGB)},
                                                      {AOLIB_NAMED(GL_BLEND_EQUATION_ALPHA)}}) {
            GLint value = 0;
            gl_.has.indexedBlend ? gl_.GetIntegeri_v(query, index, &value)
                                 : gl_.GetIntegerv(query, &value);
            to.value(name, i, value);
        }
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(gl_.has.sampleMasks); ++i) {
        GLint mask = 0;
        gl_.GetIntegeri_v(GL_SAMPLE_MASK_VALUE, static_cast<GLuint>(i), &mask);
        to.value("GL_SAMPLE_MASK_VALUE", i, mask);
    }
}

} // namespace aolib

#undef AOLIB_NAMED
