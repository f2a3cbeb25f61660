#include "gl/StateGuard.h"

#include <algorithm>
#include <functional>

#include "gl/GuardedNames.h"

namespace aolib::gl {

namespace {

GLint queried(const Functions& gl, GLenum name) {
    GLint value = 0;
    gl.GetIntegerv(name, &value);
    return value;
}

void toggle(const Functions& gl, GLenum name, bool enabled) {
    enabled ? gl.Enable(name) : gl.Disable(name);
}

bool isAlignment(GLenum name) {
    return name == GL_PACK_ALIGNMENT || name == GL_UNPACK_ALIGNMENT;
}

} // namespace

StateGuard::StateGuard(const Functions& gl) : gl_(gl), output_(gl) {
    saveToggles();
    saveBindings();
    savePixelPaths();
    saveRasterState();
    setCleanSlate();
}

StateGuard::~StateGuard() {
    restoreBindings();
    restorePixelPaths();
    restoreRasterState();
    output_.restore(gl_);
    restoreToggles();
    if (feedbackPaused_) {
        gl_.ResumeTransformFeedback();
    }
}

bool StateGuard::hostSrgb() const {
    return std::any_of(toggles_.begin(), toggles_.end(), [](const Toggle& t) {
        return t.name == GL_FRAMEBUFFER_SRGB && t.enabled == GL_TRUE;
    });
}

bool StateGuard::hostScissor() const {
    return std::any_of(indexedToggles_.begin(), indexedToggles_.end(), [](const IndexedToggle& t) {
        return t.name == GL_SCISSOR_TEST && t.enabled.front() == GL_TRUE;
    });
}

void StateGuard::saveToggles() {
    std::vector<GLenum> names(kToggles.begin(), kToggles.end());
    const Functions::Capabilities& can = gl_.capabilities;
    if (can.sampleShading) {
        names.push_back(GL_SAMPLE_SHADING);
    }
    if (can.fixedIndexRestart) {
        names.push_back(GL_PRIMITIVE_RESTART_FIXED_INDEX);
    }
    if (can.compatibility) {
        names.insert(names.end(), {kAlphaTest, kPolygonStipple, kLineStipple});
    }
    for (int i = 0; i < can.maxClipDistances; ++i) {
        names.push_back(GL_CLIP_DISTANCE0 + static_cast<GLenum>(i));
    }
    for (const GLenum name : names) {
        toggles_.push_back({name, gl_.IsEnabled(name)});
    }
    IndexedToggle blend{GL_BLEND, {}};
    for (int i = 0; i < can.maxDrawBuffers; ++i) {
        blend.enabled.push_back(gl_.IsEnabledi(GL_BLEND, static_cast<GLuint>(i)));
    }
    indexedToggles_.push_back(std::move(blend));
    IndexedToggle scissor{GL_SCISSOR_TEST, {}};
    for (int i = 0; i < can.maxViewports; ++i) {
        scissor.enabled.push_back(can.viewportArray
                                      ? gl_.IsEnabledi(GL_SCISSOR_TEST, static_cast<GLuint>(i))
                                      : gl_.IsEnabled(GL_SCISSOR_TEST));
    }
    indexedToggles_.push_back(std::move(scissor));
}

void StateGuard::restoreToggles() const {
    for (const Toggle& saved : toggles_) {
        toggle(gl_, saved.name, saved.enabled == GL_TRUE);
    }
    for (const IndexedToggle& saved : indexedToggles_) {
        // One value for all is set for all: Enablei on a scissor test needs viewport arrays.
        const bool uniform = std::adjacent_find(saved.enabled.begin(), saved.enabled.end(),
                                                std::not_equal_to<>()) == saved.enabled.end();
        if (uniform) {
            toggle(gl_, saved.name, saved.enabled.front() == GL_TRUE);
            continue;
        }
        for (std::size_t i = 0; i < saved.enabled.size(); ++i) {
            const auto index = static_cast<GLuint>(i);
            saved.enabled[i] == GL_TRUE ? gl_.Enablei(saved.name, index)
                                        : gl_.Disablei(saved.name, index);
        }
    }
}

void StateGuard::saveBindings() {
    drawFramebuffer_ = queried(gl_, GL_DRAW_FRAMEBUFFER_BINDING);
    readFramebuffer_ = queried(gl_, GL_READ_FRAMEBUFFER_BINDING);
    program_ = queried(gl_, GL_CURRENT_PROGRAM);
    vertexArray_ = queried(gl_, GL_VERTEX_ARRAY_BINDING);
    arrayBuffer_ = queried(gl_, GL_ARRAY_BUFFER_BINDING);
    packBuffer_ = queried(gl_, GL_PIXEL_PACK_BUFFER_BINDING);
    unpackBuffer_ = queried(gl_, GL_PIXEL_UNPACK_BUFFER_BINDING);
    if (gl_.capabilities.queryBuffer) {
        queryBuffer_ = queried(gl_, GL_QUERY_BUFFER_BINDING);
    }
    activeTexture_ = queried(gl_, GL_ACTIVE_TEXTURE);
    for (std::size_t i = 0; i < textureUnits_.size(); ++i) {
        gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        textureUnits_[i] = {queried(gl_, GL_TEXTURE_BINDING_2D),
                            queried(gl_, GL_TEXTURE_BINDING_2D_ARRAY),
                            queried(gl_, GL_SAMPLER_BINDING)};
    }
    if (gl_.capabilities.pauseFeedback && queried(gl_, GL_TRANSFORM_FEEDBACK_ACTIVE) == GL_TRUE &&
        queried(gl_, GL_TRANSFORM_FEEDBACK_PAUSED) == GL_FALSE) {
        gl_.PauseTransformFeedback();
        feedbackPaused_ = true;
    }
}

void StateGuard::restoreBindings() const {
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawFramebuffer_));
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(readFramebuffer_));
    gl_.UseProgram(static_cast<GLuint>(program_));
    gl_.BindVertexArray(static_cast<GLuint>(vertexArray_));
    gl_.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(arrayBuffer_));
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(packBuffer_));
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(unpackBuffer_));
    if (gl_.capabilities.queryBuffer) {
        gl_.BindBuffer(GL_QUERY_BUFFER, static_cast<GLuint>(queryBuffer_));
    }
    for (std::size_t i = 0; i < textureUnits_.size(); ++i) {
        gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        gl_.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(textureUnits_[i].texture));
        gl_.BindTexture(GL_TEXTURE_2D_ARRAY, static_cast<GLuint>(textureUnits_[i].textureArray));
        gl_.BindSampler(static_cast<GLuint>(i), static_cast<GLuint>(textureUnits_[i].sampler));
    }
    gl_.ActiveTexture(static_cast<GLenum>(activeTexture_));
}

void StateGuard::savePixelPaths() {
    for (const GLenum name : kPixelStore) {
        pixelStore_.push_back({name, queried(gl_, name)});
    }
    if (gl_.capabilities.packInvert) {
        pixelStore_.push_back({kPackInvert, queried(gl_, kPackInvert)});
    }
    clampReadColor_ = queried(gl_, GL_CLAMP_READ_COLOR);
    if (!gl_.capabilities.compatibility) {
        return;
    }
    clampFragmentColor_ = queried(gl_, kClampFragmentColor);
    if (gl_.PixelTransferf == nullptr) {
        return;
    }
    const auto save = [&](GLenum name) {
        GLfloat value = 0.0F;
        gl_.GetFloatv(name, &value);
        pixelTransfer_.push_back({name, value});
    };
    save(kMapColor);
    save(kMapStencil);
    for (const GLenum scale : kPixelTransferScales) {
        save(scale);
        save(scale + 1);
    }
}

void StateGuard::restorePixelPaths() const {
    for (const PixelStore& saved : pixelStore_) {
        gl_.PixelStorei(saved.name, saved.value);
    }
    gl_.ClampColor(GL_CLAMP_READ_COLOR, static_cast<GLenum>(clampReadColor_));
    if (gl_.capabilities.compatibility) {
        gl_.ClampColor(kClampFragmentColor, static_cast<GLenum>(clampFragmentColor_));
    }
    for (const PixelTransfer& saved : pixelTransfer_) {
        gl_.PixelTransferf(saved.name, saved.value);
    }
}

void StateGuard::saveRasterState() {
    gl_.GetBooleanv(GL_DEPTH_WRITEMASK, &depthMask_);
    depthFunc_ = queried(gl_, GL_DEPTH_FUNC);
    gl_.GetIntegerv(GL_POLYGON_MODE, polygonMode_.data());
    frontFace_ = queried(gl_, GL_FRONT_FACE);
    provokingVertex_ = queried(gl_, GL_PROVOKING_VERTEX);
    gl_.GetFloatv(GL_LINE_WIDTH, &lineWidth_);
    if (gl_.capabilities.clipControl) {
        clipOrigin_ = queried(gl_, GL_CLIP_ORIGIN);
        clipDepthMode_ = queried(gl_, GL_CLIP_DEPTH_MODE);
    }
}

void StateGuard::restoreRasterState() const {
    gl_.DepthMask(depthMask_);
    gl_.DepthFunc(static_cast<GLenum>(depthFunc_));
    if (gl_.capabilities.compatibility) {
        gl_.PolygonMode(GL_FRONT, static_cast<GLenum>(polygonMode_[0]));
        gl_.PolygonMode(GL_BACK, static_cast<GLenum>(polygonMode_[1]));
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

void StateGuard::setCleanSlate() const {
    for (const Toggle& saved : toggles_) {
        gl_.Disable(saved.name);
    }
    for (const IndexedToggle& saved : indexedToggles_) {
        gl_.Disable(saved.name);
    }
    gl_.Enable(GL_MULTISAMPLE); // as GL starts with it
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    if (gl_.capabilities.queryBuffer) {
        gl_.BindBuffer(GL_QUERY_BUFFER, 0);
    }
    for (int i = 0; i < kTextureUnits; ++i) {
        gl_.BindSampler(static_cast<GLuint>(i), 0);
    }
    for (const PixelStore& saved : pixelStore_) {
        gl_.PixelStorei(saved.name, isAlignment(saved.name) ? 1 : 0);
    }
    gl_.ClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
    if (gl_.capabilities.compatibility) {
        gl_.ClampColor(kClampFragmentColor, GL_FALSE);
    }
    for (const PixelTransfer& saved : pixelTransfer_) {
        const bool scale = std::find(kPixelTransferScales.begin(), kPixelTransferScales.end(),
                                     saved.name) != kPixelTransferScales.end();
        gl_.PixelTransferf(saved.name, scale ? 1.0F : 0.0F);
    }
    gl_.DepthMask(GL_TRUE);
    gl_.DepthFunc(GL_LESS);
    gl_.DepthRange(0.0, 1.0);
    gl_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl_.FrontFace(GL_CCW);
    // Besides what is flat, it decides the last bit of what is not: in which order vertices count.
    gl_.ProvokingVertex(GL_LAST_VERTEX_CONVENTION);
    gl_.LineWidth(1.0F);
    // Even with blending off, Mesa refuses to draw to several targets with a dual-source function.
    gl_.BlendFuncSeparate(GL_ONE, GL_ZERO, GL_ONE, GL_ZERO);
    gl_.BlendEquationSeparate(GL_FUNC_ADD, GL_FUNC_ADD);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (gl_.capabilities.clipControl) {
        gl_.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    }
}

} // namespace aolib::gl
