// Objects bound wherever GL takes one.
#include "Poison.h"

namespace aolib {

void Poison::bindTextures(Dice& dice) {
    for (int unit = 0; unit < gl_.has.textureUnits; ++unit) {
        gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        for (const auto& [target, names] : objects_.textures) {
            gl_.BindTexture(target, any(dice, names));
        }
        gl_.BindSampler(static_cast<GLuint>(unit), any(dice, objects_.samplers));
    }
    gl_.ActiveTexture(GL_TEXTURE0 +
                      static_cast<GLenum>(dice.integer(0, 0, gl_.has.textureUnits - 1)));
    if (!gl_.has.imageUnits) {
        return;
    }
    for (int unit = 0; unit < 8; ++unit) {
        const GLuint texture = any(dice, objects_.textures.at(GL_TEXTURE_2D));
        gl_.BindImageTexture(static_cast<GLuint>(unit), texture, dice.integer(0, 1, 2), GL_FALSE, 0,
                             dice.pick<GLenum>(GL_READ_ONLY, {GL_WRITE_ONLY, GL_READ_WRITE}),
                             dice.pick<GLenum>(GL_R8, {GL_RGBA8, GL_R32F}));
    }
}

void Poison::bindBuffers(Dice& dice) {
    const auto indexed = [&](GLenum target, GLenum limit) {
        for (int i = 0; i < gl_.integer(limit); ++i) {
            const GLuint name = any(dice, objects_.buffers);
            const auto index = static_cast<GLuint>(i);
            if (name != 0 && dice.chance(0.5)) {
                gl_.BindBufferRange(target, index, name, 256 * dice.between(0, 3), 512);
            } else {
                gl_.BindBufferBase(target, index, name);
            }
        }
    };
    indexed(GL_UNIFORM_BUFFER, GL_MAX_UNIFORM_BUFFER_BINDINGS);
    if (gl_.has.atomicCounters) {
        indexed(GL_ATOMIC_COUNTER_BUFFER, GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS);
    }
    if (gl_.has.shaderStorage) {
        indexed(GL_SHADER_STORAGE_BUFFER, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS);
    }
    const auto bind = [&](GLenum target) { gl_.BindBuffer(target, any(dice, objects_.buffers)); };
    for (const GLenum target :
         GLenums{GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, GL_PIXEL_PACK_BUFFER,
                 GL_PIXEL_UNPACK_BUFFER, GL_TEXTURE_BUFFER, GL_UNIFORM_BUFFER}) {
        bind(target);
    }
    if (gl_.has.indirect) {
        bind(GL_DRAW_INDIRECT_BUFFER);
    }
    if (gl_.has.compute) {
        bind(GL_DISPATCH_INDIRECT_BUFFER);
    }
    if (gl_.has.queryBuffer) {
        bind(GL_QUERY_BUFFER);
    }
    if (gl_.has.parameterBuffer) {
        bind(GL_PARAMETER_BUFFER);
    }
}

void Poison::bindVertices(Dice& dice) {
    gl_.BindVertexArray(any(dice, objects_.vertexArrays));
    // A compatibility context has no current value for attribute 0.
    for (int i = 1; i < gl_.has.attributes; ++i) {
        gl_.VertexAttrib4f(static_cast<GLuint>(i), dice.real(0, -9, 9), dice.real(0, -9, 9),
                           dice.real(0, -9, 9), dice.real(1, -9, 9));
    }
}

void Poison::bindFramebuffers(Dice& dice, const HostView& view) {
    const auto kind = static_cast<HostTarget>(dice.below(kHostTargets));
    const GLuint read =
        dice.unusual() ? objects_.framebuffer(kind) : objects_.framebuffer(view.target);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, read);
    if (read != 0) {
        gl_.ReadBuffer(dice.pick<GLenum>(GL_COLOR_ATTACHMENT0, {GL_NONE}));
    }
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, objects_.framebuffer(view.target));
    if (view.target == HostTarget::ManyColours) {
        // Location 0 goes to texture 0, the other anywhere.
        const GLenum buffers[] = {
            GL_COLOR_ATTACHMENT0,
            dice.pick<GLenum>(GL_COLOR_ATTACHMENT1, {GL_NONE, GL_COLOR_ATTACHMENT2})};
        gl_.DrawBuffers(2, buffers);
    }
    gl_.BindRenderbuffer(GL_RENDERBUFFER, any(dice, objects_.renderbuffers));
}

} // namespace aolib
