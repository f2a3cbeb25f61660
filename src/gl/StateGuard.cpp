#include "gl/StateGuard.h"

#include <utility>

#include "gl/GuardedNames.h"

namespace aolib::gl {

namespace {

GLint queried(const Functions& gl, GLenum name) {
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

struct NamedToggle {
    GLenum name;
    bool StateTrust::*part;
};

/// What is switched off, and of which part it is.
std::vector<NamedToggle> togglesOf(const Functions& gl) {
    const Functions::Capabilities& can = gl.capabilities;
    std::vector<NamedToggle> all;
    const auto add = [&all](const auto& names, bool StateTrust::*part) {
        for (const GLenum name : names) {
            all.push_back({name, part});
        }
    };
    add(kDepthToggles, &StateTrust::depth);
    add(kBlendToggles, &StateTrust::blending);
    add(kRasterToggles, &StateTrust::raster);
    if (can.sampleShading) {
        all.push_back({GL_SAMPLE_SHADING, &StateTrust::raster});
    }
    if (can.fixedIndexRestart) {
        all.push_back({GL_PRIMITIVE_RESTART_FIXED_INDEX, &StateTrust::raster});
    }
    if (can.compatibility) {
        all.push_back({kAlphaTest, &StateTrust::blending});
        add(std::array{kPolygonStipple, kLineStipple}, &StateTrust::raster);
    }
    for (int i = 0; i < can.maxClipDistances; ++i) {
        all.push_back({GL_CLIP_DISTANCE0 + static_cast<GLenum>(i), &StateTrust::raster});
    }
    return all;
}

} // namespace

StateGuard::StateGuard(const Functions& gl, const Scope& scope)
    : gl_(gl), outer_(std::exchange(gl.guard, this)), scope_(scope),
      output_(gl, {scope.trusted.blending, scope.trusted.viewports, scope.everything}),
      textureUnits_(gl, scope.trusted.textures), pixelPaths_(gl, scope.trusted.pixels) {
    saveToggles();
    saveBindings();
    saveRasterState();
    pauseFeedback();
    setCleanSlate();
}

StateGuard::~StateGuard() {
    restoreBindings();
    textureUnits_.restore();
    pixelPaths_.restore();
    restoreRasterState();
    output_.restore();
    restoreToggles();
    if (feedbackPaused_) {
        gl_.ResumeTransformFeedback();
    }
    gl_.guard = outer_;
}

void StateGuard::saveToggles() {
    for (const NamedToggle& toggle : togglesOf(gl_)) {
        const bool trusted = scope_.trusted.*toggle.part;
        const bool read = toggle.name == GL_FRAMEBUFFER_SRGB;
        const GLboolean enabled = !trusted || read ? gl_.IsEnabled(toggle.name) : GL_FALSE;
        srgb_ = read ? enabled : srgb_;
        if (!trusted) {
            toggles_.push_back({toggle.name, enabled});
        }
        gl_.Disable(toggle.name);
    }
    gl_.Enable(GL_MULTISAMPLE); // as GL starts with it
}

void StateGuard::restoreToggles() const {
    for (const Toggle& saved : toggles_) {
        saved.enabled == GL_TRUE ? gl_.Enable(saved.name) : gl_.Disable(saved.name);
    }
}

void StateGuard::saveBindings() {
    drawFramebuffer_ = queried(gl_, GL_DRAW_FRAMEBUFFER_BINDING);
    if (!scope_.trusted.framebuffers) {
        readFramebuffer_ = queried(gl_, GL_READ_FRAMEBUFFER_BINDING);
    }
    if (!scope_.trusted.programs) {
        program_ = queried(gl_, GL_CURRENT_PROGRAM);
        vertexArray_ = queried(gl_, GL_VERTEX_ARRAY_BINDING);
        arrayBuffer_ = queried(gl_, GL_ARRAY_BUFFER_BINDING);
    }
    if (gl_.capabilities.queryBuffer && !scope_.trusted.pixels) {
        queryBuffer_ = queried(gl_, GL_QUERY_BUFFER_BINDING);
    }
}

void StateGuard::restoreBindings() const {
    if (!scope_.trusted.framebuffers) {
        gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawFramebuffer_));
        gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(readFramebuffer_));
    }
    if (!scope_.trusted.programs || feedbackPaused_) {
        gl_.UseProgram(static_cast<GLuint>(program_));
    }
    if (!scope_.trusted.programs) {
        gl_.BindVertexArray(static_cast<GLuint>(vertexArray_));
        gl_.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(arrayBuffer_));
    }
    if (queryBuffer_ != 0) {
        gl_.BindBuffer(GL_QUERY_BUFFER, static_cast<GLuint>(queryBuffer_));
    }
}

void StateGuard::saveRasterState() {
    if (!scope_.trusted.depth) {
        gl_.GetBooleanv(GL_DEPTH_WRITEMASK, &depthMask_);
        depthFunc_ = queried(gl_, GL_DEPTH_FUNC);
    }
    if (gl_.capabilities.clipControl) {
        clipOrigin_ = queried(gl_, GL_CLIP_ORIGIN);
        clipDepthMode_ = queried(gl_, GL_CLIP_DEPTH_MODE);
    }
    if (scope_.trusted.raster) {
        return;
    }
    gl_.GetIntegerv(GL_POLYGON_MODE, polygonMode_.data());
    frontFace_ = queried(gl_, GL_FRONT_FACE);
    provokingVertex_ = queried(gl_, GL_PROVOKING_VERTEX);
    gl_.GetFloatv(GL_LINE_WIDTH, &lineWidth_);
    if (gl_.capabilities.compatibility) {
        clampFragmentColor_ = queried(gl_, kClampFragmentColor);
    }
}

void StateGuard::restoreRasterState() const {
    if (!scope_.trusted.depth) {
        gl_.DepthMask(depthMask_);
        gl_.DepthFunc(static_cast<GLenum>(depthFunc_));
    }
    if (scope_.trusted.raster) {
        return;
    }
    if (gl_.capabilities.compatibility) {
        gl_.PolygonMode(GL_FRONT, static_cast<GLenum>(polygonMode_[0]));
        gl_.PolygonMode(GL_BACK, static_cast<GLenum>(polygonMode_[1]));
        gl_.ClampColor(kClampFragmentColor, static_cast<GLenum>(clampFragmentColor_));
    } else {
        gl_.PolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(polygonMode_[0]));
    }
    gl_.FrontFace(static_cast<GLenum>(frontFace_));
    gl_.ProvokingVertex(static_cast<GLenum>(provokingVertex_));
    gl_.LineWidth(lineWidth_);
    if (gl_.capabilities.clipControl) {
        gl_.ClipControl(static_cast<GLenum>(clipOrigin_), static_cast<GLenum>(clipDepthMode_));
    }
}

void StateGuard::pauseFeedback() {
    if (gl_.capabilities.pauseFeedback && queried(gl_, GL_TRANSFORM_FEEDBACK_ACTIVE) == GL_TRUE &&
        queried(gl_, GL_TRANSFORM_FEEDBACK_PAUSED) == GL_FALSE) {
        program_ = queried(gl_, GL_CURRENT_PROGRAM); // to resume, it must be the same
        gl_.PauseTransformFeedback();
        feedbackPaused_ = true;
    }
}

void StateGuard::setCleanSlate() {
    if (scope_.everything) {
        textureUnits_.useAll();
        pixelPaths_.use();
    }
    if (gl_.capabilities.queryBuffer) {
        gl_.BindBuffer(GL_QUERY_BUFFER, 0);
    }
    if (gl_.capabilities.compatibility) {
        gl_.ClampColor(kClampFragmentColor, GL_FALSE);
        pixelPaths_.use(); // pixel transfer applies to copies, too
    }
    gl_.DepthMask(GL_TRUE);
    gl_.DepthFunc(GL_LESS);
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl_.FrontFace(GL_CCW);
    // Besides what is flat, it decides the last bit of what is not: in which order vertices count.
    gl_.ProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    gl_.LineWidth(1.0F);
    if (gl_.capabilities.clipControl) {
        gl_.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    }
}

} // namespace aolib::gl
