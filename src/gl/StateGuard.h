#pragma once

#include <array>
#include <vector>

#include "gl/Functions.h"
#include "gl/OutputState.h"

namespace aolib::gl {

/// Takes the host's GL state aside and gives a clean slate; puts every piece back when it goes.
///
/// Saved by query, restored to what was found. What it covers is the list of state that aolib's
/// passes touch or that could alter them; docs/integration.md holds the table.
class StateGuard {
public:
    /// Texture units 0 ... kTextureUnits - 1 are the only ones that aolib binds to.
    static constexpr int kTextureUnits = 8;

    explicit StateGuard(const Functions& gl);
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
    bool hostSrgb() const;
    /// Of viewport 0.
    bool hostScissor() const;

private:
    struct Toggle {
        GLenum name;
        GLboolean enabled;
    };
    struct IndexedToggle {
        GLenum name;
        std::vector<GLboolean> enabled;
    };
    struct PixelStore {
        GLenum name;
        GLint value;
    };
    struct PixelTransfer {
        GLenum name;
        GLfloat value;
    };
    struct TextureUnit {
        GLint texture;
        GLint textureArray;
        GLint sampler;
    };

    void saveToggles();
    void saveBindings();
    void savePixelPaths();
    void saveRasterState();
    void setCleanSlate() const;
    void restoreToggles() const;
    void restoreBindings() const;
    void restorePixelPaths() const;
    void restoreRasterState() const;

    const Functions& gl_;
    OutputState output_;

    std::vector<Toggle> toggles_;
    std::vector<IndexedToggle> indexedToggles_;

    GLint drawFramebuffer_ = 0;
    GLint readFramebuffer_ = 0;
    GLint program_ = 0;
    GLint vertexArray_ = 0;
    GLint arrayBuffer_ = 0;
    GLint packBuffer_ = 0;
    GLint unpackBuffer_ = 0;
    GLint queryBuffer_ = 0;
    GLint activeTexture_ = 0;
    std::array<TextureUnit, kTextureUnits> textureUnits_{};

    std::vector<PixelStore> pixelStore_;
    std::vector<PixelTransfer> pixelTransfer_;
    GLint clampReadColor_ = 0;
    GLint clampFragmentColor_ = 0;

    GLboolean depthMask_ = GL_TRUE;
    GLint depthFunc_ = 0;
    std::array<GLint, 2> polygonMode_{};
    GLint frontFace_ = 0;
    GLint provokingVertex_ = 0;
    GLfloat lineWidth_ = 1.0F;
    GLint clipOrigin_ = GL_LOWER_LEFT;
    GLint clipDepthMode_ = GL_NEGATIVE_ONE_TO_ONE;
    bool feedbackPaused_ = false;
};

} // namespace aolib::gl
