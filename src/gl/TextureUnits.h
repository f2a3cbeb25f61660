#pragma once

#include <array>
#include <optional>

#include "gl/Functions.h"

namespace aolib::gl {

/// The host's textures and samplers of the units that aolib binds to: taken aside when a unit is
/// first used.
class TextureUnits {
public:
    /// Units 0 ... kCount - 1 are the only ones that aolib binds to.
    static constexpr int kCount = 8;

    /// @param trusted  nothing is queried, and restore() does nothing.
    TextureUnits(const Functions& gl, bool trusted);
    /// Before `target` of a unit is bound to; makes the unit active and takes its sampler away.
    void use(int unit, GLenum target);
    void useAll();
    void restore() const;

private:
    struct Unit {
        bool used = false;
        GLint sampler = 0;
        std::optional<GLint> texture;
        std::optional<GLint> textureArray;
    };

    const Functions& gl_;
    bool trusted_;
    GLint active_ = 0;
    std::array<Unit, kCount> units_{};
};

} // namespace aolib::gl
