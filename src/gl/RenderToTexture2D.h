#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <aolib/Status.h>

#include "gl/Container.h"
#include "gl/Handle.h"

namespace aolib::gl {

/// Textures of one size that can be rendered to, one or several at a time, with or without a depth
/// texture (thesis 4.2.2). The enumerations are its own and name no GL type.
class RenderToTexture2D {
public:
    enum class Format : std::uint8_t {
        R8,
        RG8,
        RGB8,
        RGBA8,
        R16,
        RG16,
        R16F,
        RG16F,
        RGBA16F,
        R32F,
        RG32F,
        RGB32F,
        RGBA32F,
    };
    enum class Wrap : std::uint8_t { Clamp, Repeat };
    enum class Filter : std::uint8_t { Nearest, Linear };
    enum class Depth : std::uint8_t {
        None,
        Depth16,
        Depth24,
        Depth32,
        Depth32F,
        Depth24Stencil8,
        Depth32FStencil8,
    };

    struct Settings {
        int width = 0;               ///< texels
        int height = 0;              ///< texels
        std::vector<Format> targets; ///< one texture each
        Depth depth = Depth::None;
        Wrap wrapS = Wrap::Clamp;
        Wrap wrapT = Wrap::Clamp;
        Filter minFilter = Filter::Nearest;
        Filter magFilter = Filter::Nearest;
        std::string label; ///< for debuggers: "aolib/cube3"

        bool operator==(const Settings&) const = default;
    };

    RenderToTexture2D() = default;
    /// Leaves its framebuffer bound. Errors: MissingCapability (size or format), OutOfMemory.
    static Result<RenderToTexture2D> create(const Functions& gl, const Settings& settings);

    /// Becomes one of these settings, unless it is. May leave its framebuffer bound.
    /// Errors: as create(); it then stays what it was.
    AoStatus reset(const Functions& gl, const Settings& settings);

    /// Directs rendering to one target, or to all of them as locations 0, 1, ...; sets the
    /// viewport.
    void bindAsTarget(int target) const;
    void bindAllAsTargets() const;
    /// Directs reading to one target.
    void bindForReading(int target) const;
    /// Makes a target readable by samplers of this texture unit.
    void bindTexture(int target, int unit) const;
    void bindDepthTexture(int unit) const;

    /// GL's name of a target's texture.
    GLuint textureName(int target) const {
        return textures_[static_cast<std::size_t>(target)].name();
    }
    /// GL's name of the framebuffer in the current context.
    GLuint framebufferName() const { return framebuffer_.name(); }

    int width() const { return settings_.width; }
    int height() const { return settings_.height; }
    /// GPU memory of all textures.
    std::size_t bytes() const;
    static std::size_t bytesPerTexel(Format format);
    static std::size_t bytesPerTexel(Depth depth);

    explicit operator bool() const { return static_cast<bool>(framebuffer_); }

private:
    AoStatus addTexture(Texture& texture, GLenum internalFormat, GLenum format, GLenum type,
                        const std::string& label);
    AoStatus addFramebuffer();
    void bindTextureName(GLuint name, int unit) const;

    const Functions* gl_ = nullptr;
    Settings settings_;
    Container framebuffer_;
    std::vector<Texture> textures_;
    Texture depth_;
};

} // namespace aolib::gl
