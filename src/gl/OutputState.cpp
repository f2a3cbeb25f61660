#include "gl/OutputState.h"

#include <algorithm>

namespace aolib::gl {

namespace {

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

} // namespace

OutputState::OutputState(const Functions& gl) {
    saveBlendState(gl);
    saveViewports(gl);
}

void OutputState::restore(const Functions& gl) const {
    restoreBlendState(gl);
    restoreViewports(gl);
}

void OutputState::saveBlendState(const Functions& gl) {
    const bool indexed = gl.capabilities.indexedBlend;
    constexpr std::array<GLenum, 4> kFactors{GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
                                             GL_BLEND_DST_ALPHA};
    constexpr std::array<GLenum, 2> kEquations{GL_BLEND_EQUATION_RGB, GL_BLEND_EQUATION_ALPHA};
    const int buffers = gl.capabilities.maxDrawBuffers;
    for (int i = 0; i < (indexed ? buffers : 1); ++i) {
        BlendState& state = blend_.emplace_back();
        const auto get = [&](GLenum name, GLint* value) {
            indexed ? gl.GetIntegeri_v(name, static_cast<GLuint>(i), value)
                    : gl.GetIntegerv(name, value);
        };
        for (std::size_t k = 0; k < kFactors.size(); ++k) {
            get(kFactors[k], &state.factors[k]);
        }
        for (std::size_t k = 0; k < kEquations.size(); ++k) {
            get(kEquations[k], &state.equations[k]);
        }
    }
    for (int i = 0; i < buffers; ++i) {
        gl.GetBooleani_v(GL_COLOR_WRITEMASK, static_cast<GLuint>(i),
                         colorMasks_.emplace_back().data());
    }
}

void OutputState::restoreBlendState(const Functions& gl) const {
    for (std::size_t i = 0; i < blend_.size(); ++i) {
        std::array<GLenum, 4> f{};
        std::array<GLenum, 2> e{};
        std::copy(blend_[i].factors.begin(), blend_[i].factors.end(), f.begin());
        std::copy(blend_[i].equations.begin(), blend_[i].equations.end(), e.begin());
        if (gl.capabilities.indexedBlend) {
            gl.BlendFuncSeparatei(static_cast<GLuint>(i), f[0], f[1], f[2], f[3]);
        } else {
            gl.BlendFuncSeparate(f[0], f[1], f[2], f[3]);
        }
        setBlendEquation(gl, static_cast<GLuint>(i), e[0], e[1]);
    }
    for (std::size_t i = 0; i < colorMasks_.size(); ++i) {
        const std::array<GLboolean, 4>& m = colorMasks_[i];
        gl.ColorMaski(static_cast<GLuint>(i), m[0], m[1], m[2], m[3]);
    }
}

void OutputState::saveViewports(const Functions& gl) {
    gl.GetIntegerv(GL_VIEWPORT, viewport_.data());
    for (int i = 0; i < gl.capabilities.maxViewports; ++i) {
        const auto index = static_cast<GLuint>(i);
        std::array<GLfloat, 4>& box = viewports_.emplace_back();
        std::array<GLdouble, 2>& range = depthRanges_.emplace_back();
        if (gl.capabilities.viewportArray) {
            gl.GetFloati_v(GL_VIEWPORT, index, box.data());
            gl.GetDoublei_v(GL_DEPTH_RANGE, index, range.data());
        } else {
            gl.GetFloatv(GL_VIEWPORT, box.data());
            gl.GetDoublev(GL_DEPTH_RANGE, range.data());
        }
    }
}

void OutputState::restoreViewports(const Functions& gl) const {
    if (!gl.capabilities.viewportArray) {
        gl.Viewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
        gl.DepthRange(depthRanges_[0][0], depthRanges_[0][1]);
        return;
    }
    for (std::size_t i = 0; i < viewports_.size(); ++i) {
        const auto index = static_cast<GLuint>(i);
        gl.ViewportIndexedfv(index, viewports_[i].data());
        gl.DepthRangeIndexed(index, depthRanges_[i][0], depthRanges_[i][1]);
    }
}

} // namespace aolib::gl
