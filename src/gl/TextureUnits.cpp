#include "gl/TextureUnits.h"

namespace aolib::gl {

TextureUnits::TextureUnits(const Functions& gl, bool trusted) : gl_(gl), trusted_(trusted) {
    if (!trusted_) {
        gl_.GetIntegerv(GL_ACTIVE_TEXTURE, &active_);
    }
}

void TextureUnits::use(int unit, GLenum target) {
    Unit& at = units_[static_cast<std::size_t>(unit)];
    gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    if (!at.used) {
        at.used = true;
        if (!trusted_) {
            gl_.GetIntegerv(GL_SAMPLER_BINDING, &at.sampler);
        }
        gl_.BindSampler(static_cast<GLuint>(unit), 0);
    }
    const bool array = target == GL_TEXTURE_2D_ARRAY;
    std::optional<GLint>& saved = array ? at.textureArray : at.texture;
    if (!trusted_ && !saved) {
        gl_.GetIntegerv(array ? GL_TEXTURE_BINDING_2D_ARRAY : GL_TEXTURE_BINDING_2D,
                        &saved.emplace(0));
    }
}

void TextureUnits::useAll() {
    for (int unit = 0; unit < kCount; ++unit) {
        use(unit, GL_TEXTURE_2D);
        use(unit, GL_TEXTURE_2D_ARRAY);
    }
}

void TextureUnits::restore() const {
    if (trusted_) {
        return;
    }
    for (int i = 0; i < kCount; ++i) {
        const Unit& unit = units_[static_cast<std::size_t>(i)];
        if (!unit.used) {
            continue;
        }
        gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(i));
        if (unit.texture) {
            gl_.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(*unit.texture));
        }
        if (unit.textureArray) {
            gl_.BindTexture(GL_TEXTURE_2D_ARRAY, static_cast<GLuint>(*unit.textureArray));
        }
        gl_.BindSampler(static_cast<GLuint>(i), static_cast<GLuint>(unit.sampler));
    }
    gl_.ActiveTexture(static_cast<GLenum>(active_));
}

} // namespace aolib::gl
