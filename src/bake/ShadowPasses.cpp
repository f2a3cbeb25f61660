#include "bake/ShadowPasses.h"

#include <algorithm>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "bake/BakeShaders.h"
#include "gl/Label.h"

namespace aolib::bake {

namespace {

using Format = gl::RenderToTexture2D::Format;
using Depth = gl::RenderToTexture2D::Depth;

/// Side by side, so that the texture is about as wide as high.
constexpr int tilesAcross = 4;

} // namespace

Result<ShadowPasses> ShadowPasses::create(const gl::Functions& gl, const Settings& settings) {
    ShadowPasses passes;
    passes.gl_ = &gl;
    passes.settings_ = settings;
    const int side = std::max(1, gl.capabilities.maxTextureSize / settings.depthSize);
    passes.settings_.mapsPerPass =
        std::min(settings.mapsPerPass, std::min(tilesAcross, side) * side);
    const int maps = passes.settings_.mapsPerPass;
    const int across = std::min({maps, tilesAcross, side});
    passes.tiles_ = {across, (maps + across - 1) / across};
    Status status;
    const auto keep = [&](auto& place, auto result) {
        if (status) {
            status = result.status();
        }
        if (result) {
            place = std::move(*result);
        }
    };
    keep(passes.depthShader_, buildBakeShader(gl, "bake/depth.vert", "bake/depth.frag"));
    keep(passes.gatherShader_,
         buildBakeShader(gl, "bake/fullscreen.vert", "bake/shadow_gather.frag"));
    gl::RenderToTexture2D::Settings depths;
    depths.width = passes.tiles_.x * settings.depthSize;
    depths.height = passes.tiles_.y * settings.depthSize;
    depths.depth = Depth::Depth32F;
    depths.label = "aolib/bake/depths";
    keep(passes.depths_, gl::RenderToTexture2D::create(gl, depths));
    gl::RenderToTexture2D::Settings sums;
    sums.width = settings.size.x;
    sums.height = settings.size.y;
    sums.targets = {Format::RGBA32F};
    sums.label = "aolib/bake/sums";
    keep(passes.sums_, gl::RenderToTexture2D::create(gl, sums));
    keep(passes.receivers_,
         gl::TextureStack::create(
             gl, {settings.size.x, settings.size.y, 3, Format::RGBA32F, "aolib/bake/receivers"}));
    keep(passes.fullscreen_, gl::VertexArray::createEmpty(gl, "aolib/bake/fullscreen"));
    return status ? Result<ShadowPasses>(std::move(passes)) : status;
}

void ShadowPasses::begin(const BakeFrame& frame,
                         std::span<const std::optional<SurfacePoint>> receivers) {
    sums_.begin(0);
    const glm::vec4 nothing(0.0F);
    gl_->ClearBufferfv(GL_COLOR, 0, glm::value_ptr(nothing));
    std::vector<glm::vec4> layer(receivers.size());
    for (int number = 0; number < 3; ++number) {
        for (std::size_t i = 0; i < receivers.size(); ++i) {
            layer[i] = glm::vec4(0.0F);
            if (!receivers[i]) {
                continue;
            }
            const SurfacePoint& point = *receivers[i];
            layer[i] = number == 0   ? glm::vec4(frame.toFrame(point.position), 1.0F)
                       : number == 1 ? glm::vec4(glm::vec3(point.normal), 0.0F)
                                     : glm::vec4(glm::vec3(point.plane), 0.0F);
        }
        receivers_.upload(number, {0, 0}, settings_.size, layer.data());
    }
}

glm::ivec2 ShadowPasses::tile(std::size_t number) const {
    const int i = static_cast<int>(number);
    return glm::ivec2(i % tiles_.x, i / tiles_.x) * settings_.depthSize;
}

void ShadowPasses::addDirections(const BakeVertices& vertices, std::span<const LightView> views) {
    const gl::DebugGroup group(*gl_, "aolib/bake/shadow maps");
    drawDepths(vertices, views);
    gather(views);
}

void ShadowPasses::drawDepths(const BakeVertices& vertices, std::span<const LightView> views) {
    depths_.beginAll();
    const float farthest = 1.0F;
    gl_->ClearBufferfv(GL_DEPTH, 0, &farthest);
    gl_->Enable(GL_DEPTH_TEST);
    depthShader_.bind();
    for (std::size_t i = 0; i < views.size(); ++i) {
        const glm::ivec2 origin = tile(i);
        gl_->Viewport(origin.x, origin.y, settings_.depthSize, settings_.depthSize);
        depthShader_.set("uToLight", views[i].toClip);
        vertices.draw();
    }
    gl_->Disable(GL_DEPTH_TEST);
}

void ShadowPasses::gather(std::span<const LightView> views) {
    sums_.begin(0);
    receivers_.bind(0);
    depths_.bindDepthTexture(1);
    gatherShader_.bind();
    gatherShader_.set("uReceivers", 0);
    gatherShader_.set("uDepth", 1);
    gatherShader_.set("uCount", static_cast<int>(views.size()));
    gatherShader_.set("uBias", settings_.bias);
    gatherShader_.set("uGround", settings_.ground);
    const glm::vec2 whole(depths_.width(), depths_.height());
    std::vector<glm::vec4> tiles;
    std::vector<glm::vec4> directions;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const glm::vec2 scale = glm::vec2(float(settings_.depthSize)) / whole;
        const glm::vec2 offset = glm::vec2(tile(i)) / whole;
        tiles.emplace_back(scale.x, scale.y, offset.x, offset.y);
        const auto texel = static_cast<float>(std::max(views[i].pixel.x, views[i].pixel.y));
        directions.emplace_back(glm::vec3(views[i].direction), texel);
        gatherShader_.set(("uToLight[" + std::to_string(i) + "]").c_str(), views[i].toClip);
    }
    gatherShader_.set("uTile", std::span<const glm::vec4>(tiles));
    gatherShader_.set("uDirections", std::span<const glm::vec4>(directions));
    gl_->Enablei(GL_BLEND, 0);
    gl_->BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    fullscreen_.drawFullscreen();
    gl_->Disablei(GL_BLEND, 0);
}

std::vector<glm::vec4> ShadowPasses::sums() const {
    std::vector<glm::vec4> texels(static_cast<std::size_t>(settings_.size.x) *
                                  static_cast<std::size_t>(settings_.size.y));
    sums_.beginRead(0);
    gl_->ReadPixels(0, 0, settings_.size.x, settings_.size.y, GL_RGBA, GL_FLOAT, texels.data());
    return texels;
}

} // namespace aolib::bake
