#include "bake/shadow/ShadowPasses.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "bake/gpu/BakeShaders.h"
#include "gl/Label.h"

namespace aolib::bake {

Result<ShadowPasses> ShadowPasses::create(const gl::Functions& gl, const DepthSettings& settings,
                                          const BakeVertices& vertices) {
    Result<DepthTiles> tiles = DepthTiles::create(gl, settings.size, settings.mapsPerPass);
    if (!tiles) {
        return tiles.status();
    }
    Result<gl::GLSLShader> gather =
        buildBakeShader(gl, "bake/fullscreen.vert", "bake/shadow_gather.frag");
    if (!gather) {
        return gather.status();
    }
    ShadowPasses passes;
    passes.gl_ = &gl;
    passes.vertices_ = &vertices;
    passes.settings_ = settings;
    passes.tiles_ = std::move(*tiles);
    passes.gatherShader_ = std::move(*gather);
    return passes;
}

AoStatus ShadowPasses::addDirections(std::span<const LightView> views, ReceiverSums& sums) {
    const gl::DebugGroup group(*gl_, "aolib/bake/shadow maps");
    drawDepths(views);
    gather(views, sums);
    return {};
}

void ShadowPasses::drawDepths(std::span<const LightView> views) {
    tiles_.begin(true);
    for (std::size_t i = 0; i < views.size(); ++i) {
        tiles_.beginMap(static_cast<int>(i), views[i].toClip);
        vertices_->draw();
    }
    tiles_.end();
}

void ShadowPasses::gather(std::span<const LightView> views, ReceiverSums& sums) {
    tiles_.bind(1);
    gatherShader_.bind();
    gatherShader_.set("uDepth", 1);
    gatherShader_.set("uCount", static_cast<int>(views.size()));
    gatherShader_.set("uBias", settings_.bias);
    gatherShader_.set("uGround", settings_.ground);
    const glm::vec2 whole(tiles_.texels());
    const glm::vec2 scale = glm::vec2(float(tiles_.size())) / whole;
    std::vector<glm::vec4> tiles;
    std::vector<glm::vec4> directions;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const glm::vec2 offset = glm::vec2(tiles_.origin(static_cast<int>(i))) / whole;
        tiles.emplace_back(scale.x, scale.y, offset.x, offset.y);
        const auto texel = static_cast<float>(std::max(views[i].pixel.x, views[i].pixel.y));
        directions.emplace_back(glm::vec3(views[i].direction), texel);
        gatherShader_.set(("uToLight[" + std::to_string(i) + "]").c_str(), views[i].toClip);
    }
    gatherShader_.set("uTile", std::span<const glm::vec4>(tiles));
    gatherShader_.set("uDirections", std::span<const glm::vec4>(directions));
    sums.add(gatherShader_);
}

} // namespace aolib::bake
