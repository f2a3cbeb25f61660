#include "backbone/frame/HostFramebuffer.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace aolib {

namespace {

using Depth = gl::RenderToTexture2D::Depth;

struct HostDepth {
    GLint bits = 0;
    GLint stencilBits = 0;
    bool floating = false;
};

GLint readAttachmentValue(const gl::Functions& gl, GLenum attachment, GLenum name) {
    GLint value = 0;
    gl.GetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, attachment, name, &value);
    return value;
}

bool hasAttachment(const gl::Functions& gl, GLenum attachment) {
    return readAttachmentValue(gl, attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE;
}

/// Formats of the depth and stencil of the framebuffer bound for reading.
HostDepth hostDepth(const gl::Functions& gl, bool isDefault) {
    const GLenum depth = isDefault ? GL_DEPTH : GL_DEPTH_ATTACHMENT;
    const GLenum stencil = isDefault ? GL_STENCIL : GL_STENCIL_ATTACHMENT;
    HostDepth found;
    if (hasAttachment(gl, depth)) {
        found.bits = readAttachmentValue(gl, depth, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
        found.floating = readAttachmentValue(gl, depth, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) ==
                         static_cast<GLint>(GL_FLOAT);
    }
    if (hasAttachment(gl, stencil)) {
        found.stencilBits =
            readAttachmentValue(gl, stencil, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE);
    }
    return found;
}

/// A texture format to which the depth can be resolved: it must match.
Depth matching(const HostDepth& host) {
    if (host.floating) {
        return host.stencilBits > 0 ? Depth::Depth32FStencil8 : Depth::Depth32F;
    }
    if (host.bits <= 16) {
        return Depth::Depth16;
    }
    if (host.bits > 24) {
        return Depth::Depth32;
    }
    return host.stencilBits > 0 ? Depth::Depth24Stencil8 : Depth::Depth24;
}

} // namespace

AoStatus HostFramebuffer::acquire(const BackboneContext& context, Frame& frame) {
    const gl::Functions& gl = context.gl;
    gl.BindFramebuffer(GL_FRAMEBUFFER, frame.depthFramebuffer);
    if (const GLenum state = gl.CheckFramebufferStatus(GL_READ_FRAMEBUFFER);
        state != GL_FRAMEBUFFER_COMPLETE) {
        return {StatusCode::InvalidFramebuffer,
                "the host's framebuffer " + std::to_string(frame.depthFramebuffer) +
                    " is incomplete (status " + std::to_string(state) + ")"};
    }
    const HostDepth host = hostDepth(gl, frame.depthFramebuffer == 0);
    if (host.bits == 0) {
        return {StatusCode::InvalidFramebuffer, "the host's framebuffer " +
                                                    std::to_string(frame.depthFramebuffer) +
                                                    " has no depth buffer"};
    }
    frame.clip.depthQuantum = std::exp2(-std::min(24, host.bits));
    if (AoStatus status = copyDepth(context, frame, matching(host)); !status) {
        return status;
    }
    return frame.hostNormals ? copyNormals(gl, frame) : AoStatus();
}

AoStatus HostFramebuffer::copyDepth(const BackboneContext& context, const Frame& frame,
                                    Depth format) {
    const gl::Functions& gl = context.gl;
    GLint samples = 0;
    gl.GetIntegerv(GL_SAMPLES, &samples);
    sampled_ = false;
    if (HostSamples::canCopy(gl, samples)) {
        AoStatus status = samples_.acquire(context, frame, format, samples);
        sampled_ = status.ok() && samples_.count() == samples;
        if (!status || sampled_) {
            return status;
        }
    }
    return copyOneSample(gl, frame, format, samples);
}

AoStatus HostFramebuffer::copyOneSample(const gl::Functions& gl, const Frame& frame, Depth format,
                                        int samples) {
    if (AoStatus status = depth_.reset(gl, {.width = frame.size.x,
                                            .height = frame.size.y,
                                            .targets = {},
                                            .depth = format,
                                            .label = "aolib/frame/depth"});
        !status) {
        return status;
    }
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, frame.depthFramebuffer);
    const glm::ivec2 o = frame.origin;
    const glm::ivec2 s = frame.size;
    if (samples > 0) {
        depth_.bindAllAsTargets();
        gl.BindFramebuffer(GL_READ_FRAMEBUFFER, frame.depthFramebuffer);
        gl.BlitFramebuffer(o.x, o.y, o.x + s.x, o.y + s.y, 0, 0, s.x, s.y, GL_DEPTH_BUFFER_BIT,
                           GL_NEAREST);
    } else {
        depth_.bindDepthTexture(0);
        gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, o.x, o.y, s.x, s.y);
    }
    return {};
}

AoStatus HostFramebuffer::copyNormals(const gl::Functions& gl, const Frame& frame) {
    if (AoStatus status = normals_.reset(gl, {.width = frame.size.x,
                                              .height = frame.size.y,
                                              .targets = {gl::RenderToTexture2D::Format::RGBA16F},
                                              .label = "aolib/frame/normals"});
        !status) {
        return status;
    }
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, frame.depthFramebuffer);
    const bool shifted =
        readAttachmentValue(gl, GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) ==
        static_cast<GLint>(GL_UNSIGNED_NORMALIZED);
    normalCode_ = shifted ? glm::vec2(2.0F, -1.0F) : glm::vec2(1.0F, 0.0F);
    normals_.bindTexture(0, 0);
    gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, frame.origin.x, frame.origin.y, frame.size.x,
                         frame.size.y);
    return {};
}

} // namespace aolib
