#include "backbone/passes/CubeMapOutlines.h"

#include <glm/gtc/matrix_transform.hpp>

#include "backbone/frame/ShaderLibrary.h"
#include "backbone/passes/Composite.h"
#include "gl/Label.h"
#include "gl/StateGuard.h"

namespace aolib {

namespace {

constexpr int kEdgeVertices = 24;
/// Half the wire cube's edge as a share of the scene's size.
constexpr float kHalfEdge = 0.005F;
constexpr glm::vec3 kColour{0.1F, 0.35F, 1.0F};

} // namespace

Result<CubeMapOutlines> CubeMapOutlines::create(const BackboneContext& context) {
    auto shader = buildShader(context.gl, "cubemap/outline.vert", "cubemap/outline.frag");
    if (!shader) {
        return shader.status();
    }
    CubeMapOutlines outlines;
    outlines.shader_ = std::move(*shader);
    return outlines;
}

void CubeMapOutlines::draw(const FrameContext& context,
                           const std::vector<CubeMapProjector*>& projectors) {
    const gl::Functions& gl = context.gl;
    const gl::DebugGroup group(gl, "aolib: cube map outlines");
    beginHostColours(context);
    gl.Enable(GL_DEPTH_TEST);
    const bool rangeReversed = context.frame.clip.depthRange[0] > context.frame.clip.depthRange[1];
    gl.DepthFunc(context.frame.camera.reversedDepth() != rangeReversed ? GL_GEQUAL : GL_LEQUAL);
    gl.DepthMask(GL_FALSE);
    gl::setDepthRange(gl, context.frame.clip.depthRange[0], context.frame.clip.depthRange[1]);
    if (gl.capabilities.clipControl) {
        gl.ClipControl(context.frame.clip.upperLeft ? GL_UPPER_LEFT : GL_LOWER_LEFT,
                       context.frame.clip.zeroToOne ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
    }
    shader_.bind();
    shader_.set("uHalfEdge", kHalfEdge * context.scene.bounds().diagonal());
    shader_.set("uColour", kColour);
    const glm::dmat4 eyeToClip = context.frame.camera.projection() *
                                 glm::dmat4(glm::inverse(context.frame.camera.eyeToWorld()));
    for (const CubeMapProjector* projector : projectors) {
        const glm::dvec3 offset = glm::dvec3(projector->position()) - context.frame.camera.eye();
        shader_.set("uCubeToClip", glm::mat4(eyeToClip * glm::translate(glm::dmat4(1.0), offset)));
        context.emptyVertexArray.drawGenerated(GL_LINES, kEdgeVertices);
    }
    if (gl.capabilities.clipControl) {
        gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    }
    gl::setDepthRange(gl, 0.0, 1.0);
    gl.DepthMask(GL_TRUE);
    gl.DepthFunc(GL_LESS);
    gl.Disable(GL_DEPTH_TEST);
    endHostColours(context);
}

} // namespace aolib
