#include "gl/OutputState.h"

#include <algorithm>

namespace aolib::gl {

namespace {

constexpr std::array<GLenum, 4> kFactors{GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
                                         GL_BLEND_DST_ALPHA};
constexpr std::array<GLenum, 2> kEquations{GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};

void setBlendEquation(const Functions& gl, GLuint buffer, GLenum colour, GLenum alpha) {
    // The advanced equations of KHR_blend_equation_advanced exist for both at once only.
    const bool indexed = gl.capabilities.indexedBlend;
    if (colour == alpha) {
        indexed ? gl.BlendEquationi(buffer, colour) : gl.BlendEquation(colour);
    } else {
        indexed ? gl.BlendEquationSeparatei(buffer, colour, alpha)
                : gl.BlendEquationSeparate(colour, alpha);
    }
}

void setBlendFunction(const Functions& gl, GLuint buffer, const std::array<GLenum, 4>& f) {
    if (gl.capabilities.indexedBlend) {
        gl.BlendFuncSeparatei(buffer, f[0], f[1], f[2], f[3]);
    } else {
        gl.BlendFuncSeparate(f[0], f[1], f[2], f[3]);
    }
}

} // namespace

OutputState::OutputState(const Functions& gl, const Settings& settings)
    : gl_(gl), settings_(settings) {
    saveViewports();
    useTargets(settings_.everything ? gl_.capabilities.maxDrawBuffers : 1);
    setDepthRange(gl_, 0.0, 1.0);
    setScissorTest(gl_, false);
    if (settings_.everything && gl_.capabilities.viewportArray) {
        gl_.DepthRange(0.0, 1.0);
        gl_.Disable(GL_SCISSOR_TEST);
    }
}

void OutputState::restore() const {
    for (int i = 0; i < static_cast<int>(targets_.size()); ++i) {
        restoreTarget(i);
    }
    if (!settings_.trustViewports) {
        restoreViewports();
    }
}

void OutputState::useTargets(int count) {
    for (; used_ < std::min(count, gl_.capabilities.maxDrawBuffers); ++used_) {
        if (!settings_.trustBlending) {
            targets_.push_back(queried(used_));
        }
        setNeutral(used_);
    }
}

/// Whether a draw buffer has a blend function of its own: else the first one's is that of all.
bool OutputState::combinesAlone(int target) const {
    return gl_.capabilities.indexedBlend || target == 0;
}

OutputState::Target OutputState::queried(int target) const {
    const auto index = static_cast<GLuint>(target);
    Target found{};
    found.blend = gl_.IsEnabledi(GL_BLEND, index);
    gl_.GetBooleani_v(GL_COLOR_WRITEMASK, index, found.mask.data());
    if (combinesAlone(target)) {
        const auto get = [&](GLenum name, GLint* value) {
            gl_.capabilities.indexedBlend ? gl_.GetIntegeri_v(name, index, value)
                                          : gl_.GetIntegerv(name, value);
        };
        for (std::size_t k = 0; k < kFactors.size(); ++k) {
            get(kFactors[k], &found.factors[k]);
        }
        for (std::size_t k = 0; k < kEquations.size(); ++k) {
            get(kEquations[k], &found.equations[k]);
        }
    }
    return found;
}

void OutputState::setNeutral(int target) const {
    const auto index = static_cast<GLuint>(target);
    gl_.Disablei(GL_BLEND, index);
    gl_.ColorMaski(index, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    // Even with blending off, Mesa refuses to draw to several targets with a dual-source function.
    if (combinesAlone(target)) {
        setBlendFunction(gl_, index, {GL_ONE, GL_ZERO, GL_ONE, GL_ZERO});
        setBlendEquation(gl_, index, GL_FUNC_ADD, GL_FUNC_ADD);
    }
}

void OutputState::restoreTarget(int target) const {
    const auto index = static_cast<GLuint>(target);
    const Target& saved = targets_[static_cast<std::size_t>(target)];
    saved.blend == GL_TRUE ? gl_.Enablei(GL_BLEND, index) : gl_.Disablei(GL_BLEND, index);
    gl_.ColorMaski(index, saved.mask[0], saved.mask[1], saved.mask[2], saved.mask[3]);
    if (combinesAlone(target)) {
        std::array<GLenum, 4> factors{};
        std::copy(saved.factors.begin(), saved.factors.end(), factors.begin());
        setBlendFunction(gl_, index, factors);
        setBlendEquation(gl_, index, static_cast<GLenum>(saved.equations[0]),
                         static_cast<GLenum>(saved.equations[1]));
    }
}

void OutputState::saveViewports() {
    gl_.GetIntegerv(GL_VIEWPORT, viewport_.data());
    const bool indexed = gl_.capabilities.viewportArray;
    const bool all = settings_.everything && !settings_.trustViewports;
    for (int i = 0; i < (all ? gl_.capabilities.maxViewports : 1); ++i) {
        const auto index = static_cast<GLuint>(i);
        std::array<GLdouble, 2>& range = depthRanges_.emplace_back();
        if (indexed) {
            gl_.GetDoublei_v(GL_DEPTH_RANGE, index, range.data());
            scissors_.push_back(gl_.IsEnabledi(GL_SCISSOR_TEST, index));
        } else {
            gl_.GetDoublev(GL_DEPTH_RANGE, range.data());
            scissors_.push_back(gl_.IsEnabled(GL_SCISSOR_TEST));
        }
        if (indexed && !settings_.trustViewports) {
            gl_.GetFloati_v(GL_VIEWPORT, index, viewports_.emplace_back().data());
        }
    }
}

void OutputState::restoreViewports() const {
    if (!gl_.capabilities.viewportArray) {
        gl_.Viewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
        gl_.DepthRange(depthRanges_[0][0], depthRanges_[0][1]);
        setScissorTest(gl_, scissor());
        return;
    }
    for (std::size_t i = 0; i < viewports_.size(); ++i) {
        const auto index = static_cast<GLuint>(i);
        gl_.ViewportIndexedfv(index, viewports_[i].data());
        gl_.DepthRangeIndexed(index, depthRanges_[i][0], depthRanges_[i][1]);
        scissors_[i] == GL_TRUE ? gl_.Enablei(GL_SCISSOR_TEST, index)
                                : gl_.Disablei(GL_SCISSOR_TEST, index);
    }
}

void setViewport(const Functions& gl, int x, int y, int width, int height) {
    if (gl.capabilities.viewportArray) {
        const std::array<GLfloat, 4> box{static_cast<GLfloat>(x), static_cast<GLfloat>(y),
                                         static_cast<GLfloat>(width), static_cast<GLfloat>(height)};
        gl.ViewportIndexedfv(0, box.data());
    } else {
        gl.Viewport(x, y, width, height);
    }
}

void setDepthRange(const Functions& gl, double near, double far) {
    gl.capabilities.viewportArray ? gl.DepthRangeIndexed(0, near, far) : gl.DepthRange(near, far);
}

void setScissorTest(const Functions& gl, bool enabled) {
    if (gl.capabilities.viewportArray) {
        enabled ? gl.Enablei(GL_SCISSOR_TEST, 0) : gl.Disablei(GL_SCISSOR_TEST, 0);
    } else {
        enabled ? gl.Enable(GL_SCISSOR_TEST) : gl.Disable(GL_SCISSOR_TEST);
    }
}

void beginBlending(const Functions& gl, GLenum source, GLenum destination, GLenum sourceAlpha,
                   GLenum destinationAlpha) {
    gl.Enablei(GL_BLEND, 0);
    setBlendFunction(gl, 0, {source, destination, sourceAlpha, destinationAlpha});
}

void endBlending(const Functions& gl) {
    gl.Disablei(GL_BLEND, 0);
}

int drawBuffersInUse(const Functions& gl) {
    int count = 1;
    for (int i = 1; i < gl.capabilities.maxDrawBuffers; ++i) {
        GLint buffer = GL_NONE;
        gl.GetIntegerv(GL_DRAW_BUFFER0 + static_cast<GLenum>(i), &buffer);
        count = buffer != GL_NONE ? i + 1 : count;
    }
    return count;
}

} // namespace aolib::gl
