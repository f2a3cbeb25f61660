#pragma once

#include <array>
#include <vector>

#include <aolib/StateTrust.h>

#include "gl/Functions.h"
#include "gl/OutputState.h"
#include "gl/PixelPaths.h"
#include "gl/TextureUnits.h"

namespace aolib::gl {

/// Takes the host's GL state aside and gives a known GL state; puts every piece back when it goes.
///
/// Saved by query, restored to what was found. What it covers is the list of state that aolib's
/// passes touch or that could alter them; docs/integration.md holds the table. Some of it is taken
/// aside when a pass is about to touch it: texture units, pixel paths, draw buffers but the first.
class StateGuard {
public:
    struct Scope {
        /// Neither queried nor restored, but for what a frame reads.
        StateTrust trusted = {};
        /// All at once: foreign code will run, or code that does not say what it touches.
        bool everything = true;
    };

    explicit StateGuard(const Functions& gl) : StateGuard(gl, Scope{}) {}
    StateGuard(const Functions& gl, const Scope& scope);
    ~StateGuard();
    StateGuard(const StateGuard&) = delete;
    StateGuard& operator=(const StateGuard&) = delete;

    GLuint hostDrawFramebuffer() const { return static_cast<GLuint>(drawFramebuffer_); }
    /// x, y, width, height of viewport 0, pixels, rounded as GL rounds it.
    const std::array<GLint, 4>& hostViewport() const { return output_.viewport(); }
    /// Near and far of viewport 0.
    const std::array<GLdouble, 2>& hostDepthRange() const { return output_.depthRange(); }
    GLenum hostClipOrigin() const { return static_cast<GLenum>(clipOrigin_); }
    GLenum hostClipDepthMode() const { return static_cast<GLenum>(clipDepthMode_); }
    bool hostSrgb() const { return srgb_ == GL_TRUE; }
    /// Of viewport 0.
    bool hostScissor() const { return output_.scissor(); }

    /// Before what is named is touched.
    TextureUnits& textureUnits() { return textureUnits_; }
    PixelPaths& pixelPaths() { return pixelPaths_; }
    OutputState& output() { return output_; }

    /// Debug groups that the host's stack has room for; -1 before anybody has asked GL.
    int debugRoom = -1;

private:
    struct Toggle {
        GLenum name;
        GLboolean enabled;
    };

    void saveToggles();
    void saveBindings();
    void saveRasterState();
    void pauseFeedback();
    void setCleanSlate();
    void restoreToggles() const;
    void restoreBindings() const;
    void restoreRasterState() const;

    const Functions& gl_;
    StateGuard* outer_;
    Scope scope_;
    OutputState output_;
    TextureUnits textureUnits_;
    PixelPaths pixelPaths_;

    std::vector<Toggle> toggles_; ///< to restore
    GLboolean srgb_ = GL_FALSE;
    GLint drawFramebuffer_ = 0;
    GLint readFramebuffer_ = 0;
    GLint program_ = 0;
    GLint vertexArray_ = 0;
    GLint arrayBuffer_ = 0;
    GLint queryBuffer_ = 0;
    GLboolean depthMask_ = GL_TRUE;
    GLint depthFunc_ = 0;
    GLint clampFragmentColor_ = 0;
    std::array<GLint, 2> polygonMode_{};
    GLint frontFace_ = 0;
    GLint provokingVertex_ = 0;
    GLfloat lineWidth_ = 1.0F;
    GLint clipOrigin_ = GL_LOWER_LEFT;
    GLint clipDepthMode_ = GL_NEGATIVE_ONE_TO_ONE;
    bool feedbackPaused_ = false;
};

/// Binds a texture of GL_TEXTURE_2D or GL_TEXTURE_2D_ARRAY to a unit, which becomes active.
inline void bindTexture(const Functions& gl, int unit, GLenum target, GLuint name) {
    if (gl.guard != nullptr) {
        gl.guard->textureUnits().use(unit, target);
    } else {
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    }
    gl.BindTexture(target, name);
}

/// Before pixels are uploaded, read back or copied from a buffer.
inline void usePixels(const Functions& gl) {
    if (gl.guard != nullptr) {
        gl.guard->pixelPaths().use();
    }
}

/// Before drawing to draw buffers 0 ... count - 1.
inline void useTargets(const Functions& gl, int count) {
    if (gl.guard != nullptr) {
        gl.guard->output().useTargets(count);
    }
}

} // namespace aolib::gl
