// Switches and numbers.
#include <initializer_list>

#include "Poison.h"

namespace aolib {

namespace {

constexpr std::initializer_list<GLenum> kCompare{GL_NEVER,   GL_LESS,     GL_EQUAL,  GL_LEQUAL,
                                                 GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
constexpr std::initializer_list<GLenum> kStencilOps{GL_ZERO,   GL_REPLACE,   GL_INCR,     GL_DECR,
                                                    GL_INVERT, GL_INCR_WRAP, GL_DECR_WRAP};
constexpr std::initializer_list<GLenum> kFactors{GL_ZERO,
                                                 GL_ONE,
                                                 GL_SRC_COLOR,
                                                 GL_ONE_MINUS_SRC_COLOR,
                                                 GL_DST_COLOR,
                                                 GL_SRC_ALPHA,
                                                 GL_DST_ALPHA,
                                                 GL_ONE_MINUS_DST_ALPHA,
                                                 GL_CONSTANT_COLOR,
                                                 GL_CONSTANT_ALPHA,
                                                 GL_SRC_ALPHA_SATURATE,
                                                 GL_SRC1_COLOR};
constexpr std::initializer_list<GLenum> kEquations{GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT,
                                                   GL_MIN, GL_MAX};
constexpr std::initializer_list<GLenum> kHints{GL_FASTEST, GL_NICEST};

} // namespace

void Poison::setSwitches(Dice& dice) {
    for (const GLenum name : GLenums{
             GL_COLOR_LOGIC_OP, GL_CULL_FACE, GL_DEPTH_CLAMP, GL_DEPTH_TEST, GL_LINE_SMOOTH,
             GL_POLYGON_OFFSET_FILL, GL_POLYGON_OFFSET_LINE, GL_POLYGON_OFFSET_POINT,
             GL_POLYGON_SMOOTH, GL_PRIMITIVE_RESTART, GL_PROGRAM_POINT_SIZE, GL_RASTERIZER_DISCARD,
             GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_ALPHA_TO_ONE, GL_SAMPLE_COVERAGE,
             GL_SAMPLE_MASK, GL_STENCIL_TEST, GL_TEXTURE_CUBE_MAP_SEAMLESS}) {
        toggle(name, dice.flag(false));
    }
    toggle(GL_DITHER, dice.flag(true));
    toggle(GL_MULTISAMPLE, dice.flag(true));
    if (gl_.has.fixedIndexRestart) {
        toggle(GL_PRIMITIVE_RESTART_FIXED_INDEX, dice.flag(false));
    }
    if (gl_.has.sampleShading) {
        toggle(GL_SAMPLE_SHADING, dice.flag(false));
        gl_.MinSampleShading(dice.real(0.0F, 0.0F, 1.0F));
    }
    if (gl_.has.advancedBlend) {
        toggle(GL_BLEND_ADVANCED_COHERENT_KHR, dice.flag(true));
    }
    if (gl_.has.debug) {
        // The synchronous switch stays: the tests' log takes messages in this thread alone.
        toggle(GL_DEBUG_OUTPUT, dice.chance(0.1) ? dice.flag(debugOutput_) : debugOutput_);
        toggle(GL_DEBUG_OUTPUT_SYNCHRONOUS, debugSynchronous_);
    }
    for (int i = 0; i < gl_.has.clipDistances; ++i) {
        toggle(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i), dice.flag(false));
    }
}

void Poison::setDepthAndStencil(Dice& dice) {
    gl_.DepthFunc(dice.pick<GLenum>(GL_LESS, kCompare));
    gl_.DepthMask(dice.flag(true) ? GL_TRUE : GL_FALSE);
    gl_.ClearDepth(dice.real(1.0F, 0.0F, 1.0F));
    gl_.ClearStencil(dice.integer(0, 0, 255));
    for (const GLenum face : GLenums{GL_FRONT, GL_BACK}) {
        gl_.StencilFuncSeparate(face, dice.pick<GLenum>(GL_ALWAYS, kCompare),
                                dice.integer(0, 0, 255),
                                static_cast<GLuint>(dice.integer(255, 0, 255)));
        gl_.StencilOpSeparate(face, dice.pick<GLenum>(GL_KEEP, kStencilOps),
                              dice.pick<GLenum>(GL_KEEP, kStencilOps),
                              dice.pick<GLenum>(GL_KEEP, kStencilOps));
        gl_.StencilMaskSeparate(face, static_cast<GLuint>(dice.integer(255, 0, 255)));
    }
}

void Poison::setRasterisation(Dice& dice) {
    gl_.CullFace(dice.pick<GLenum>(GL_BACK, {GL_FRONT, GL_FRONT_AND_BACK}));
    gl_.FrontFace(dice.pick<GLenum>(GL_CCW, {GL_CW}));
    if (gl_.has.compatibility) {
        gl_.PolygonMode(GL_FRONT, dice.pick<GLenum>(GL_FILL, {GL_LINE, GL_POINT}));
        gl_.PolygonMode(GL_BACK, dice.pick<GLenum>(GL_FILL, {GL_LINE, GL_POINT}));
    } else {
        gl_.PolygonMode(GL_FRONT_AND_BACK, dice.pick<GLenum>(GL_FILL, {GL_LINE, GL_POINT}));
    }
    gl_.PolygonOffset(dice.real(0.0F, -4.0F, 4.0F), dice.real(0.0F, -64.0F, 64.0F));
    if (gl_.has.polygonOffsetClamp) {
        gl_.PolygonOffsetClamp(dice.real(0.0F, -4.0F, 4.0F), dice.real(0.0F, -64.0F, 64.0F),
                               dice.real(0.0F, 0.0F, 0.1F));
    }
    gl_.LineWidth(dice.pick(1.0F, {2.0F, 5.5F}));
    gl_.PointSize(dice.real(1.0F, 0.5F, 8.0F));
    gl_.PointParameterf(GL_POINT_FADE_THRESHOLD_SIZE, dice.real(1.0F, 0.0F, 4.0F));
    gl_.PointParameteri(GL_POINT_SPRITE_COORD_ORIGIN,
                        dice.pick<GLint>(GL_UPPER_LEFT, {GL_LOWER_LEFT}));
    gl_.ProvokingVertex(dice.pick<GLenum>(GL_LAST_VERTEX_CONVENTION, {GL_FIRST_VERTEX_CONVENTION}));
    gl_.PrimitiveRestartIndex(static_cast<GLuint>(dice.integer(0, 0, 3)));
    gl_.SampleCoverage(dice.real(1.0F, 0.0F, 1.0F), dice.flag(false) ? GL_TRUE : GL_FALSE);
    for (int i = 0; i < gl_.has.sampleMasks; ++i) {
        gl_.SampleMaski(static_cast<GLuint>(i), dice.pick<GLbitfield>(~0U, {0U, 5U, 0xAAAAU}));
    }
    for (const GLenum hint :
         GLenums{GL_LINE_SMOOTH_HINT, GL_POLYGON_SMOOTH_HINT, GL_TEXTURE_COMPRESSION_HINT,
                 GL_FRAGMENT_SHADER_DERIVATIVE_HINT}) {
        gl_.Hint(hint, dice.pick<GLenum>(GL_DONT_CARE, kHints));
    }
    if (gl_.has.tessellation) {
        gl_.PatchParameteri(GL_PATCH_VERTICES, dice.integer(3, 1, 16));
        const GLfloat levels[] = {dice.real(1, 1, 8), dice.real(1, 1, 8), dice.real(1, 1, 8),
                                  dice.real(1, 1, 8)};
        gl_.PatchParameterfv(GL_PATCH_DEFAULT_INNER_LEVEL, levels);
        gl_.PatchParameterfv(GL_PATCH_DEFAULT_OUTER_LEVEL, levels);
    }
}

void Poison::setColour(Dice& dice) {
    gl_.BlendColor(dice.real(0, 0, 1), dice.real(0, 0, 1), dice.real(0, 0, 1), dice.real(0, 0, 1));
    gl_.ClearColor(dice.real(0, 0, 1), dice.real(0, 0, 1), dice.real(0, 0, 1), dice.real(0, 0, 1));
    gl_.LogicOp(dice.pick<GLenum>(GL_COPY, {GL_CLEAR, GL_INVERT, GL_XOR, GL_NOOP, GL_SET}));
    gl_.ClampColor(GL_CLAMP_READ_COLOR, dice.pick<GLenum>(GL_FIXED_ONLY, {GL_TRUE, GL_FALSE}));
    gl_.BlendFuncSeparate(dice.pick<GLenum>(GL_ONE, kFactors), dice.pick<GLenum>(GL_ZERO, kFactors),
                          dice.pick<GLenum>(GL_ONE, kFactors),
                          dice.pick<GLenum>(GL_ZERO, kFactors));
    gl_.BlendEquationSeparate(dice.pick<GLenum>(GL_FUNC_ADD, kEquations),
                              dice.pick<GLenum>(GL_FUNC_ADD, kEquations));
    toggle(GL_BLEND, false);
    for (int i = 0; i < gl_.has.drawBuffers; ++i) {
        const auto index = static_cast<GLuint>(i);
        const auto mask = [&] { return static_cast<GLboolean>(dice.flag(true)); };
        const GLboolean red = mask();
        const GLboolean green = mask();
        const GLboolean blue = mask();
        gl_.ColorMaski(index, red, green, blue, mask());
        dice.flag(false) ? gl_.Enablei(GL_BLEND, index) : gl_.Disablei(GL_BLEND, index);
        if (gl_.has.indexedBlend) {
            gl_.BlendFuncSeparatei(
                index, dice.pick<GLenum>(GL_ONE, kFactors), dice.pick<GLenum>(GL_ZERO, kFactors),
                dice.pick<GLenum>(GL_ONE, kFactors), dice.pick<GLenum>(GL_ZERO, kFactors));
            gl_.BlendEquationSeparatei(index, dice.pick<GLenum>(GL_FUNC_ADD, kEquations),
                                       dice.pick<GLenum>(GL_FUNC_ADD, kEquations));
        }
    }
    if (gl_.has.advancedBlend && dice.unusual() && dice.chance(0.3)) {
        gl_.BlendEquation(dice.pick<GLenum>(GL_MULTIPLY_KHR, {GL_SCREEN_KHR, GL_EXCLUSION_KHR}));
    }
}

void Poison::setPixelStore(Dice& dice) {
    for (const GLenum name : GLenums{GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT}) {
        gl_.PixelStorei(name, dice.pick(4, {1, 2, 8}));
    }
    for (const GLenum name :
         GLenums{GL_PACK_ROW_LENGTH, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_PACK_IMAGE_HEIGHT,
                 GL_PACK_SKIP_IMAGES, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_PIXELS,
                 GL_UNPACK_SKIP_ROWS, GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_IMAGES}) {
        gl_.PixelStorei(name, dice.integer(0, 1, 9));
    }
    for (const GLenum name : GLenums{GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_UNPACK_SWAP_BYTES,
                                     GL_UNPACK_LSB_FIRST}) {
        gl_.PixelStorei(name, dice.flag(false) ? 1 : 0);
    }
    if (gl_.has.packInvert) {
        constexpr GLenum kPackInvert = 0x8758;
        gl_.PixelStorei(kPackInvert, dice.flag(false) ? 1 : 0);
    }
}

void Poison::setViewports(Dice& dice, const HostView& view) {
    const std::array<int, 4>& v = view.viewport;
    const std::array<int, 4>& s = view.scissor;
    gl_.Viewport(v[0], v[1], v[2], v[3]);
    gl_.Scissor(s[0], s[1], s[2], s[3]);
    gl_.DepthRange(view.depthRange[0], view.depthRange[1]);
    toggle(GL_SCISSOR_TEST, view.scissorTest);
    for (int i = 1; i < gl_.has.viewports; ++i) {
        const auto index = static_cast<GLuint>(i);
        const GLfloat box[] = {dice.real(0.0F, -4.0F, 4.0F), dice.real(0.0F, -4.0F, 4.0F),
                               dice.real(16.0F, 0.0F, 40.0F), dice.real(16.0F, 0.0F, 40.0F)};
        gl_.ViewportIndexedfv(index, box);
        gl_.ScissorIndexed(index, dice.integer(0, -9, 9), dice.integer(0, -9, 9),
                           dice.integer(16, 0, 40), dice.integer(16, 0, 40));
        gl_.DepthRangeIndexed(index, dice.real(0.0F, 0.0F, 1.0F), dice.real(1.0F, 0.0F, 1.0F));
        const bool scissor = dice.flag(view.scissorTest);
        scissor ? gl_.Enablei(GL_SCISSOR_TEST, index) : gl_.Disablei(GL_SCISSOR_TEST, index);
    }
    if (gl_.has.clipControl) {
        gl_.ClipControl(view.upperLeft ? GL_UPPER_LEFT : GL_LOWER_LEFT,
                        view.zeroToOne ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
    }
}

} // namespace aolib
