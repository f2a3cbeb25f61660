#include "bake/shadow/DepthTiles.h"

#include <algorithm>
#include <utility>

#include "bake/gpu/BakeShaders.h"

namespace aolib::bake {

namespace {

/// Side by side, so that the texture is about as wide as high.
constexpr int tilesAcross = 4;

} // namespace

Result<DepthTiles> DepthTiles::create(const gl::Functions& gl, int size, int count) {
    DepthTiles tiles;
    tiles.gl_ = &gl;
    tiles.size_ = size;
    const int side = std::max(1, gl.capabilities.maxTextureSize / size);
    tiles.count_ = std::min(count, std::min(tilesAcross, side) * side);
    tiles.across_ = std::min({tiles.count_, tilesAcross, side});
    Result<gl::GLSLShader> shader = buildBakeShader(gl, "bake/depth.vert", "bake/depth.frag");
    if (!shader) {
        return shader.status();
    }
    gl::RenderToTexture2D::Settings settings;
    settings.width = tiles.across_ * size;
    settings.height = (tiles.count_ + tiles.across_ - 1) / tiles.across_ * size;
    settings.depth = gl::RenderToTexture2D::Depth::Depth32F;
    settings.label = "aolib/bake/depths";
    auto depths = gl::RenderToTexture2D::create(gl, settings);
    if (!depths) {
        return depths.status();
    }
    tiles.shader_ = std::move(*shader);
    tiles.depths_ = std::move(*depths);
    return tiles;
}

void DepthTiles::begin(bool anew) {
    depths_.bindAllAsTargets();
    if (anew) {
        const float farthest = 1.0F;
        gl_->ClearBufferfv(GL_DEPTH, 0, &farthest);
    }
    gl_->Enable(GL_DEPTH_TEST);
    shader_.bind();
}

gl::GLSLShader& DepthTiles::beginMap(int number, const glm::mat4& toClip) {
    const glm::ivec2 corner = origin(number);
    gl_->Viewport(corner.x, corner.y, size_, size_);
    shader_.set("uToLight", toClip);
    return shader_;
}

void DepthTiles::end() const {
    gl_->Disable(GL_DEPTH_TEST);
}

} // namespace aolib::bake
