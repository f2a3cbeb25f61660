// The compatibility profile's own state.
#include <array>
#include <utility>

#include "FixedFunction.h"
#include "HostState.h"

#define AOLIB_NAMED(name) #name, fixed::name

namespace aolib {

void HostState::recordFixedFunction(StateRecorder& to) const {
    for (const auto& [name, query] : NamedQueries{{AOLIB_NAMED(kAlphaTest)},
                                                  {AOLIB_NAMED(kColorMaterial)},
                                                  {AOLIB_NAMED(kColorSum)},
                                                  {AOLIB_NAMED(kFog)},
                                                  {AOLIB_NAMED(kLight0)},
                                                  {AOLIB_NAMED(kLighting)},
                                                  {AOLIB_NAMED(kLineStipple)},
                                                  {AOLIB_NAMED(kNormalize)},
                                                  {AOLIB_NAMED(kPointSmooth)},
                                                  {AOLIB_NAMED(kPointSprite)},
                                                  {AOLIB_NAMED(kPolygonStipple)},
                                                  {AOLIB_NAMED(kRescaleNormal)},
                                                  {AOLIB_NAMED(kVertexArray)},
                                                  {AOLIB_NAMED(kNormalArray)},
                                                  {AOLIB_NAMED(kColorArray)},
                                                  {AOLIB_NAMED(kIndexArray)},
                                                  {AOLIB_NAMED(kEdgeFlagArray)},
                                                  {AOLIB_NAMED(kTextureCoordArray)},
                                                  {AOLIB_NAMED(kVertexProgramTwoSide)}}) {
        to.value(name, gl_.IsEnabled(query));
    }
    const std::pair<std::pair<const char*, GLenum>, int> numbers[] = {
        {{AOLIB_NAMED(kAlphaTestFunc)}, 1},
        {{AOLIB_NAMED(kAlphaTestRef)}, 1},
        {{AOLIB_NAMED(kAccumClearValue)}, 4},
        {{AOLIB_NAMED(kAttribStackDepth)}, 1},
        {{AOLIB_NAMED(kClientActiveTexture)}, 1},
        {{AOLIB_NAMED(kClientAttribStackDepth)}, 1},
        {{AOLIB_NAMED(kColorMaterialFace)}, 1},
        {{AOLIB_NAMED(kColorMaterialParameter)}, 1},
        {{AOLIB_NAMED(kCurrentColor)}, 4},
        {{AOLIB_NAMED(kCurrentFogCoord)}, 1},
        {{AOLIB_NAMED(kCurrentNormal)}, 3},
        {{AOLIB_NAMED(kCurrentRasterColor)}, 4},
        {{AOLIB_NAMED(kCurrentRasterPosition)}, 4},
        {{AOLIB_NAMED(kCurrentSecondaryColor)}, 4},
        {{AOLIB_NAMED(kEdgeFlag)}, 1},
        {{AOLIB_NAMED(kFogColor)}, 4},
        {{AOLIB_NAMED(kFogDensity)}, 1},
        {{AOLIB_NAMED(kFogEnd)}, 1},
        {{AOLIB_NAMED(kFogHint)}, 1},
        {{AOLIB_NAMED(kFogMode)}, 1},
        {{AOLIB_NAMED(kFogStart)}, 1},
        {{AOLIB_NAMED(kGenerateMipmapHint)}, 1},
        {{AOLIB_NAMED(kLineStipplePattern)}, 1},
        {{AOLIB_NAMED(kLineStippleRepeat)}, 1},
        {{AOLIB_NAMED(kListBase)}, 1},
        {{AOLIB_NAMED(kMatrixMode)}, 1},
        {{AOLIB_NAMED(kModelViewMatrix)}, 16},
        {{AOLIB_NAMED(kModelViewStackDepth)}, 1},
        {{AOLIB_NAMED(kPerspectiveHint)}, 1},
        {{AOLIB_NAMED(kPointDistanceAttenuation)}, 3},
        {{AOLIB_NAMED(kPointSizeMax)}, 1},
        {{AOLIB_NAMED(kPointSizeMin)}, 1},
        {{AOLIB_NAMED(kPointSmoothHint)}, 1},
        {{AOLIB_NAMED(kProjectionMatrix)}, 16},
        {{AOLIB_NAMED(kProjectionStackDepth)}, 1},
        {{AOLIB_NAMED(kRenderMode)}, 1},
        {{AOLIB_NAMED(kShadeModel)}, 1},
        {{AOLIB_NAMED(kVertexArrayStride)}, 1},
        {{AOLIB_NAMED(kClampVertexColor)}, 1},
        {{AOLIB_NAMED(kClampFragmentColor)}, 1}};
    for (const auto& [named, count] : numbers) {
        floats(to, named.first, named.second, count);
    }
    std::array<GLfloat, 4> colour{};
    for (const GLenum face : GLenums{GL_FRONT, GL_BACK}) {
        for (const GLenum part :
             GLenums{fixed::kAmbient, fixed::kDiffuse, fixed::kSpecular, fixed::kEmission}) {
            gl_.GetMaterialfv(face, part, colour.data());
            to.values("material", part, colour.data(), 4);
        }
    }
    gl_.GetLightfv(fixed::kLight0, fixed::kDiffuse, colour.data());
    to.values("light 0 diffuse", 0, colour.data(), 4);
    const GLint active = gl_.integer(GL_ACTIVE_TEXTURE);
    for (int unit = 0; unit < gl_.has.coordinateUnits; ++unit) {
        const auto index = static_cast<std::size_t>(unit);
        gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        std::array<GLfloat, 16> values{};
        gl_.GetTexEnvfv(fixed::kTextureEnv, fixed::kTextureEnvMode, values.data());
        gl_.GetTexEnvfv(fixed::kTextureFilterControl, GL_TEXTURE_LOD_BIAS, values.data() + 1);
        to.values("texture environment", index, values.data(), 2);
        gl_.GetFloatv(fixed::kTextureMatrix, values.data());
        to.values("texture matrix", index, values.data(), 16);
        gl_.GetFloatv(fixed::kCurrentTextureCoords, values.data());
        to.values("current texture coordinates", index, values.data(), 4);
        for (const GLenum target :
             GLenums{GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D, GL_TEXTURE_CUBE_MAP}) {
            to.value("texture target enabled", index, gl_.IsEnabled(target));
        }
    }
    gl_.ActiveTexture(static_cast<GLenum>(active));
}

void HostState::recordPixelTransfer(StateRecorder& to) const {
    for (const auto& [name, query] : NamedQueries{{AOLIB_NAMED(kMapColor)},
                                                  {AOLIB_NAMED(kMapStencil)},
                                                  {AOLIB_NAMED(kIndexShift)},
                                                  {AOLIB_NAMED(kIndexOffset)},
                                                  {AOLIB_NAMED(kZoomX)},
                                                  {AOLIB_NAMED(kZoomY)}}) {
        floats(to, name, query);
    }
    for (const auto& [name, query] : NamedQueries{{AOLIB_NAMED(kRedScale)},
                                                  {AOLIB_NAMED(kGreenScale)},
                                                  {AOLIB_NAMED(kBlueScale)},
                                                  {AOLIB_NAMED(kAlphaScale)},
                                                  {AOLIB_NAMED(kDepthScale)}}) {
        floats(to, name, query);
        floats(to, "and its bias", query + 1);
    }
    // Pixel maps and the stipple come through the pixel store: into memory, tightly packed.
    const GLint pack = gl_.integer(GL_PIXEL_PACK_BUFFER_BINDING);
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    for (int map = 0; map < fixed::kPixelMaps; ++map) {
        std::array<GLfloat, 256> content{};
        const auto offset = static_cast<GLenum>(map);
        const GLint size = gl_.integer(fixed::kFirstPixelMapSize + offset);
        to.value("pixel map size", offset, size);
        gl_.GetPixelMapfv(fixed::kFirstPixelMap + offset, content.data());
        to.values("pixel map", offset, content.data(), 4);
    }
    const std::array<std::pair<GLenum, GLint>, 6> plain{{{GL_PACK_SWAP_BYTES, 0},
                                                         {GL_PACK_LSB_FIRST, 0},
                                                         {GL_PACK_ROW_LENGTH, 0},
                                                         {GL_PACK_SKIP_ROWS, 0},
                                                         {GL_PACK_SKIP_PIXELS, 0},
                                                         {GL_PACK_ALIGNMENT, 1}}};
    std::array<GLint, 6> store{};
    for (std::size_t i = 0; i < plain.size(); ++i) {
        store[i] = gl_.integer(plain[i].first);
        gl_.PixelStorei(plain[i].first, plain[i].second);
    }
    std::array<GLubyte, 128> stipple{};
    gl_.GetPolygonStipple(stipple.data());
    to.values("polygon stipple", 0, stipple.data(), 128);
    for (std::size_t i = 0; i < plain.size(); ++i) {
        gl_.PixelStorei(plain[i].first, store[i]);
    }
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(pack));
}

} // namespace aolib

#undef AOLIB_NAMED
