#include "bake/scatter/ScatterSlabs.h"

#include <algorithm>
#include <utility>

#include "bake/gpu/BakeShaders.h"
#include "bake/scatter/FirstError.h"

namespace aolib::bake {

namespace {

/// Slabs whose triangles are sorted at once: all triangles are looked at for each so many.
constexpr int slabsAtOnce = 16;

} // namespace

Result<ScatterSlabs> ScatterSlabs::create(const gl::Functions& gl, int rasterSize,
                                          const BakeVertices& vertices) {
    ScatterSlabs slabs(gl, vertices);
    FirstError firstError;
    firstError.assign(slabs.depthShader_,
                      buildBakeShader(gl, "bake/depth.vert", "bake/depth.frag"));
    firstError.assign(slabs.hideShader_,
                      buildBakeShader(gl, "bake/fullscreen.vert", "bake/scatter_hide.frag"));
    gl::RenderToTexture2D::Settings settings;
    settings.width = settings.height = rasterSize;
    settings.depth = gl::RenderToTexture2D::Depth::Depth32F;
    settings.label = "aolib/bake/before";
    firstError.assign(slabs.before_, gl::RenderToTexture2D::create(gl, settings));
    firstError.assign(slabs.fullscreen_, gl::VertexArray::createEmpty(gl, "aolib/bake/fullscreen"));
    return firstError.status() ? Result<ScatterSlabs>(std::move(slabs)) : firstError.status();
}

void ScatterSlabs::begin(const LightView& view) {
    slabs_.emplace(view);
    triangles_.begin(*slabs_);
    prepared_ = 0;
}

AoStatus ScatterSlabs::prepare(int slab) {
    if (slab < prepared_) {
        return {};
    }
    prepared_ = std::min(slab + slabsAtOnce, slabs_->count());
    return triangles_.prepare(std::max(0, slab - 1), prepared_);
}

void ScatterSlabs::drawBefore(int slab) {
    before_.bindAllAsTargets();
    const float farthest = 1.0F;
    gl_->ClearBufferfv(GL_DEPTH, 0, &farthest);
    if (triangles_.empty(slab - 1)) {
        return;
    }
    gl_->Enable(GL_DEPTH_TEST);
    depthShader_.bind();
    depthShader_.set("uToLight", slabs_->farthest(slab - 1));
    triangles_.draw(depthShader_, slab - 1);
    gl_->Disable(GL_DEPTH_TEST);
}

void ScatterSlabs::draw(gl::GLSLShader& shader, int slab) {
    triangles_.draw(shader, slab);
    if (triangles_.empty(slab - 1)) {
        return;
    }
    before_.bindDepthTexture(3);
    hideShader_.bind();
    hideShader_.set("uBefore", 3);
    gl_->DepthFunc(GL_GREATER);
    fullscreen_.drawFullscreen();
    gl_->DepthFunc(GL_LESS);
}

} // namespace aolib::bake
