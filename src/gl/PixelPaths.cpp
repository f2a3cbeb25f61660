#include "gl/PixelPaths.h"

#include <algorithm>

#include "gl/GuardedNames.h"

namespace aolib::gl {

namespace {

bool isAlignment(GLenum name) {
    return name == GL_PACK_ALIGNMENT || name == GL_UNPACK_ALIGNMENT;
}

std::vector<GLenum> storeNames(const Functions& gl) {
    std::vector<GLenum> names(kPixelStore.begin(), kPixelStore.end());
    if (gl.capabilities.packInvert) {
        names.push_back(kPackInvert);
    }
    return names;
}

std::vector<GLenum> transferNames(const Functions& gl) {
    std::vector<GLenum> names;
    if (gl.capabilities.compatibility && gl.PixelTransferf != nullptr) {
        names = {kMapColor, kMapStencil};
        for (const GLenum scale : kPixelTransferScales) {
            names.insert(names.end(), {scale, scale + 1});
        }
    }
    return names;
}

} // namespace

void PixelPaths::use() {
    if (used_) {
        return;
    }
    used_ = true;
    if (!trusted_) {
        save();
    }
    set();
}

void PixelPaths::save() {
    gl_.GetIntegerv(GL_PIXEL_PACK_BUFFER_BINDING, &packBuffer_);
    gl_.GetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &unpackBuffer_);
    for (const GLenum name : storeNames(gl_)) {
        gl_.GetIntegerv(name, &store_.emplace_back(Store{name, 0}).value);
    }
    for (const GLenum name : transferNames(gl_)) {
        gl_.GetFloatv(name, &transfer_.emplace_back(Transfer{name, 0.0F}).value);
    }
    gl_.GetIntegerv(GL_CLAMP_READ_COLOR, &clampReadColor_);
}

void PixelPaths::set() const {
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    for (const GLenum name : storeNames(gl_)) {
        gl_.PixelStorei(name, isAlignment(name) ? 1 : 0);
    }
    for (const GLenum name : transferNames(gl_)) {
        const bool scale = std::find(kPixelTransferScales.begin(), kPixelTransferScales.end(),
                                     name) != kPixelTransferScales.end();
        gl_.PixelTransferf(name, scale ? 1.0F : 0.0F);
    }
    gl_.ClampColor(GL_CLAMP_READ_COLOR, GL_FALSE);
}

void PixelPaths::restore() const {
    if (!used_ || trusted_) {
        return;
    }
    gl_.BindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(packBuffer_));
    gl_.BindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(unpackBuffer_));
    for (const Store& saved : store_) {
        gl_.PixelStorei(saved.name, saved.value);
    }
    for (const Transfer& saved : transfer_) {
        gl_.PixelTransferf(saved.name, saved.value);
    }
    gl_.ClampColor(GL_CLAMP_READ_COLOR, static_cast<GLenum>(clampReadColor_));
}

} // namespace aolib::gl
