#include "backbone/texels/BoxVisibilityQuery.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "backbone/frame/ShaderLibrary.h"
#include "backbone/texels/FaceCapture.h"
#include "gl/Label.h"

namespace aolib {

namespace {

constexpr int kBoxVertices = 36;

/// The kinds of occlusion queries exclude each other.
bool hostCountsSamples(const gl::Functions& gl) {
    const auto runs = [&](GLenum kind) {
        GLint query = 0;
        gl.GetQueryiv(kind, GL_CURRENT_QUERY, &query);
        return query != 0;
    };
    return runs(GL_SAMPLES_PASSED) || runs(GL_ANY_SAMPLES_PASSED) ||
           (gl.capabilities.conservativeQuery && runs(GL_ANY_SAMPLES_PASSED_CONSERVATIVE));
}

} // namespace

Result<BoxVisibilityQuery> BoxVisibilityQuery::create(const BackboneContext& context) {
    auto shader =
        buildShader(context.gl, "cubemap/box_visibility.vert", "cubemap/box_visibility.frag");
    if (!shader) {
        return shader.status();
    }
    BoxVisibilityQuery test;
    test.shader_ = std::move(*shader);
    return test;
}

bool BoxVisibilityQuery::isVisible(const BackboneContext& context,
                                   const CubeMapProjector& projector, const FaceStore& store,
                                   const Bounds& region) {
    const gl::Functions& gl = context.gl;
    const gl::DebugGroup group(gl, "aolib: does a cube map see a change");
    const glm::vec3 centre = projector.position();
    if (region.empty()) {
        return false;
    }
    const float nearest = region.nearest(centre);
    // Inside the region, or while an occlusion query of the host's runs: no need, or no way, to
    // ask.
    if (nearest <= 0.0F || store.empty() || hostCountsSamples(gl)) {
        return true;
    }
    auto target = gl::RenderToTexture2D::create(gl, {.width = store.faceSize(),
                                                     .height = store.faceSize(),
                                                     .targets = {gl::RenderToTexture2D::Format::R8},
                                                     .label = "aolib/viewpoint"});
    const auto query = gl::generate<gl::Query>(gl, &gl::Functions::GenQueries);
    if (!target || !query) {
        return true;
    }
    const float farthest = region.farthest(centre);
    const float near = 0.5F * nearest; // below nearest / sqrt(3), so that no face clips it
    const float far = 2.0F * farthest;
    target->bindAsTarget(0);
    shader_.bind();
    store.bind(shader_, 1, 0);
    shader_.set("uDepthCode", projector.depthCode());
    shader_.set("uBoxMin", region.min - centre);
    shader_.set("uBoxMax", region.max - centre);
    shader_.set("uDepthMap",
                glm::vec2((far + near) / (far - near), -2.0F * far * near / (far - near)));
    gl.BeginQuery(GL_ANY_SAMPLES_PASSED, query.name());
    for (int face = 0; face < kFaces; ++face) {
        shader_.set("uLayer", projector.layer(face));
        shader_.set("uCubeToFace", cubeToFace(face));
        context.emptyVertexArray.drawGenerated(GL_TRIANGLES, kBoxVertices);
    }
    gl.EndQuery(GL_ANY_SAMPLES_PASSED);
    GLint seen = GL_TRUE;
    gl.GetQueryObjectiv(query.name(), GL_QUERY_RESULT, &seen);
    return seen != GL_FALSE;
}

} // namespace aolib
