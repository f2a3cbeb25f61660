// The compatibility profile's own state.
#include <array>

#include "FixedFunction.h"
#include "Poison.h"

namespace aolib {

namespace {

std::array<GLfloat, 4> colour(Dice& dice, GLfloat normal) {
    return {dice.real(normal, 0, 1), dice.real(normal, 0, 1), dice.real(normal, 0, 1),
            dice.real(1, 0, 1)};
}

std::array<GLfloat, 16> matrix(Dice& dice) {
    std::array<GLfloat, 16> m{};
    for (std::size_t i = 0; i < m.size(); ++i) {
        m[i] = dice.real(i % 5 == 0 ? 1.0F : 0.0F, -2.0F, 2.0F);
    }
    return m;
}

} // namespace

void Poison::setFixedFunction(Dice& dice) {
    using namespace fixed;
    for (const GLenum name :
         GLenums{kAlphaTest, kColorMaterial, kColorSum, kFog, kLight0, kLighting, kLineStipple,
                 kNormalize, kPointSmooth, kPointSprite, kPolygonStipple, kRescaleNormal,
                 kVertexProgramTwoSide}) {
        toggle(name, dice.flag(false));
    }
    gl_.AlphaFunc(dice.pick<GLenum>(GL_ALWAYS, {GL_NEVER, GL_GREATER, GL_LESS}),
                  dice.real(0, 0, 1));
    gl_.ClearAccum(dice.real(0, 0, 1), 0, 0, 0);
    gl_.ColorMaterial(dice.pick<GLenum>(GL_FRONT_AND_BACK, {GL_FRONT, GL_BACK}),
                      dice.pick(kAmbientAndDiffuse, {kEmission, kSpecular, kDiffuse}));
    gl_.Fogi(kFogMode, dice.pick<GLint>(0x0800, {GL_LINEAR}));
    gl_.Fogf(kFogDensity, dice.real(1, 0, 3));
    gl_.Fogf(kFogStart, dice.real(0, 0, 3));
    gl_.Fogf(kFogEnd, dice.real(1, 0, 3));
    gl_.Fogfv(kFogColor, colour(dice, 0).data());
    gl_.LineStipple(dice.integer(1, 1, 9), static_cast<GLushort>(dice.integer(0xFFFF, 0, 0xFFFF)));
    gl_.ShadeModel(dice.pick(kSmooth, {kFlat}));
    for (const GLenum part : GLenums{kAmbient, kDiffuse, kSpecular, kEmission}) {
        gl_.Materialfv(GL_FRONT_AND_BACK, part, colour(dice, 0.2F).data());
    }
    gl_.Lightfv(kLight0, kDiffuse, colour(dice, 1).data());
    gl_.ClampColor(kClampVertexColor, dice.pick<GLenum>(GL_TRUE, {GL_FALSE, kFixedOnly}));
    gl_.ClampColor(kClampFragmentColor, dice.pick<GLenum>(kFixedOnly, {GL_FALSE, GL_TRUE}));
    gl_.Color4f(dice.real(1, 0, 1), dice.real(1, 0, 1), dice.real(1, 0, 1), dice.real(1, 0, 1));
    gl_.SecondaryColor3f(dice.real(0, 0, 1), 0, 0);
    gl_.Normal3f(dice.real(0, -1, 1), 0, 1);
    gl_.TexCoord4f(dice.real(0, -1, 1), 0, 0, 1);
    gl_.FogCoordf(dice.real(0, 0, 4));
    gl_.EdgeFlag(static_cast<GLboolean>(dice.flag(true)));
    gl_.ListBase(static_cast<GLuint>(dice.integer(0, 0, 99)));
}

void Poison::setPointsAndArrays(Dice& dice) {
    using namespace fixed;
    gl_.PointParameterf(kPointSizeMin, dice.real(0, 0, 2));
    gl_.PointParameterf(kPointSizeMax, dice.real(64, 2, 64));
    const std::array<GLfloat, 3> attenuation{dice.real(1, 0, 1), dice.real(0, 0, 1),
                                             dice.real(0, 0, 1)};
    gl_.PointParameterfv(kPointDistanceAttenuation, attenuation.data());
    for (const GLenum hint :
         GLenums{kFogHint, kPerspectiveHint, kPointSmoothHint, kGenerateMipmapHint}) {
        gl_.Hint(hint, dice.pick<GLenum>(GL_DONT_CARE, {GL_NICEST, GL_FASTEST}));
    }
    gl_.ClientActiveTexture(GL_TEXTURE0 +
                            static_cast<GLenum>(dice.integer(0, 0, gl_.has.coordinateUnits - 1)));
    for (const GLenum array : GLenums{kVertexArray, kNormalArray, kColorArray, kIndexArray,
                                      kEdgeFlagArray, kTextureCoordArray}) {
        dice.flag(false) ? gl_.EnableClientState(array) : gl_.DisableClientState(array);
    }
    gl_.VertexPointer(3, GL_FLOAT, dice.integer(0, 12, 40), nullptr);
}

void Poison::setMatrices(Dice& dice) {
    using namespace fixed;
    const GLint active = gl_.integer(GL_ACTIVE_TEXTURE);
    for (int unit = 0; unit < gl_.has.coordinateUnits; ++unit) {
        gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        gl_.TexEnvf(kTextureEnv, kTextureEnvMode,
                    static_cast<GLfloat>(dice.pick<GLenum>(kModulate, {GL_BLEND, GL_REPLACE})));
        // Few values: from the 4097th sampler state on, Mesa may free one twice
        // (docs/robustness.md).
        gl_.TexEnvf(kTextureFilterControl, GL_TEXTURE_LOD_BIAS,
                    static_cast<GLfloat>(dice.integer(0, -12, 12)) / 4.0F);
        gl_.MatrixMode(GL_TEXTURE);
        gl_.LoadMatrixf(matrix(dice).data());
        for (const GLenum target : GLenums{GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_CUBE_MAP}) {
            toggle(target, dice.flag(false));
        }
    }
    gl_.ActiveTexture(static_cast<GLenum>(active));
    for (const GLenum mode : GLenums{kModelView, kProjection}) {
        gl_.MatrixMode(mode);
        gl_.LoadMatrixf(matrix(dice).data());
    }
    // A texture matrix is the mode that needs a unit that has one.
    const bool textureMode = active < static_cast<GLint>(GL_TEXTURE0) + gl_.has.coordinateUnits;
    gl_.MatrixMode(dice.pick<GLenum>(kModelView,
                                     {kProjection, textureMode ? GLenum{GL_TEXTURE} : kModelView}));
}

void Poison::pushStacks(Dice& dice) {
    if (!dice.unusual()) {
        return;
    }
    const auto mode = static_cast<GLenum>(gl_.integer(fixed::kMatrixMode));
    for (const GLenum stack : GLenums{fixed::kModelView, fixed::kProjection}) {
        gl_.MatrixMode(stack);
        gl_.PushMatrix();
    }
    gl_.MatrixMode(mode);
    gl_.PushAttrib(fixed::kCurrentBit);
    gl_.PushClientAttrib(fixed::kClientPixelStoreBit);
    stacks_ = true;
}

void Poison::popStacks() {
    gl_.PopClientAttrib();
    gl_.PopAttrib();
    for (const GLenum stack : GLenums{fixed::kModelView, fixed::kProjection}) {
        gl_.MatrixMode(stack);
        gl_.PopMatrix();
    }
    stacks_ = false;
}

void Poison::setPixelTransfer(Dice& dice) {
    using namespace fixed;
    gl_.PixelTransferi(kMapColor, dice.flag(false) ? 1 : 0);
    gl_.PixelTransferi(kMapStencil, dice.flag(false) ? 1 : 0);
    gl_.PixelTransferi(kIndexShift, dice.integer(0, -4, 4));
    gl_.PixelTransferi(kIndexOffset, dice.integer(0, -4, 4));
    for (const GLenum scale :
         GLenums{kRedScale, kGreenScale, kBlueScale, kAlphaScale, kDepthScale}) {
        gl_.PixelTransferf(scale, dice.real(1, -2, 2));
        gl_.PixelTransferf(scale + 1, dice.real(0, -1, 1));
    }
    gl_.PixelZoom(dice.real(1, -3, 3), dice.real(1, -3, 3));
    // Pixel maps and the stipple come through the unpack buffer and the pixel store.
    const GLint unpack = gl_.integer(GL_PIXEL_UNPACK_BUFFER_BINDING);
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    for (int map = 0; map < kPixelMaps; ++map) {
        const std::array<GLfloat, 4> content{dice.real(0, 0, 1), dice.real(0, 0, 1),
                                             dice.real(0, 0, 1), dice.real(0, 0, 1)};
        gl_.PixelMapfv(kFirstPixelMap + static_cast<GLenum>(map), dice.pick(1, {2, 4}),
                       content.data());
    }
    // Mesa 22 writes a byte too far when it unpacks bits that do not begin with a byte.
    const GLint skip = gl_.integer(GL_UNPACK_SKIP_PIXELS);
    gl_.PixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
    std::array<GLubyte, 1024> stipple{};
    stipple.fill(static_cast<GLubyte>(dice.integer(255, 0, 255)));
    gl_.PolygonStipple(stipple.data());
    gl_.PixelStorei(GL_UNPACK_SKIP_PIXELS, skip);
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(unpack));
}

} // namespace aolib
