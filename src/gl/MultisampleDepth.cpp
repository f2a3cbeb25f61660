#include "gl/MultisampleDepth.h"

#include "gl/Label.h"
#include "gl/StateGuard.h"
#include "gl/TexelFormat.h"

namespace aolib::gl {

namespace {

/// Unit on which a texture is made.
constexpr int kCreationUnit = 0;

} // namespace

Result<MultisampleDepth> MultisampleDepth::create(const Functions& gl, const Settings& settings) {
    MultisampleDepth depth;
    depth.gl_ = &gl;
    depth.settings_ = settings;
    depth.texture_ = generate<Texture>(gl, &Functions::GenTextures);
    if (!depth.texture_) {
        return AoStatus(StatusCode::OutOfMemory, settings.label + ": GL gave no texture name");
    }
    const MultisampleBinding binding(gl, depth.texture_.name(), kCreationUnit);
    gl::label(gl, GL_TEXTURE, depth.texture_.name(), settings.label);
    gl.TexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, settings.samples,
                             texelFormat(settings.format).internalFormat, settings.width,
                             settings.height, GL_TRUE);
    GLint width = 0;
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_WIDTH, &width);
    if (width != settings.width) {
        return AoStatus(StatusCode::OutOfMemory,
                        settings.label + ": no memory for " + std::to_string(settings.width) +
                            " x " + std::to_string(settings.height) + " pixels of " +
                            std::to_string(settings.samples) + " samples");
    }
    gl.GetTexLevelParameteriv(GL_TEXTURE_2D_MULTISAMPLE, 0, GL_TEXTURE_SAMPLES, &depth.samples_);
    auto framebuffer = Container::create(
        gl, Container::kFramebuffer, settings.label,
        [settings, texture = depth.texture_.name()](const Functions& in, GLuint name) {
            return attach(in, settings, name, texture);
        });
    if (!framebuffer) {
        return framebuffer.status();
    }
    depth.framebuffer_ = std::move(*framebuffer);
    return depth;
}

AoStatus MultisampleDepth::attach(const Functions& gl, const Settings& settings, GLuint framebuffer,
                                  GLuint texture) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl::label(gl, GL_FRAMEBUFFER, framebuffer, settings.label);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, depthAttachment(settings.format),
                            GL_TEXTURE_2D_MULTISAMPLE, texture, 0);
    gl.DrawBuffer(GL_NONE);
    gl.ReadBuffer(GL_NONE);
    const GLenum state = gl.CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (state != GL_FRAMEBUFFER_COMPLETE) {
        return {StatusCode::MissingCapability,
                settings.label + ": this driver cannot render to " +
                    std::to_string(settings.samples) +
                    " samples of the depth's format (framebuffer status " + std::to_string(state) +
                    ")"};
    }
    return {};
}

AoStatus MultisampleDepth::reset(const Functions& gl, const Settings& settings) {
    if (texture_ && settings_ == settings) {
        return {};
    }
    Result<MultisampleDepth> created = create(gl, settings);
    if (created) {
        *this = std::move(*created);
    }
    return created.status();
}

void MultisampleDepth::beginDraw() const {
    gl_->BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
}

std::size_t MultisampleDepth::bytes() const {
    return texture_ ? static_cast<std::size_t>(settings_.width) *
                          static_cast<std::size_t>(settings_.height) *
                          static_cast<std::size_t>(samples_) *
                          RenderToTexture2D::bytesPerTexel(settings_.format)
                    : 0;
}

MultisampleBinding::MultisampleBinding(const Functions& gl, GLuint texture, int unit)
    : gl_(gl), unit_(GL_TEXTURE0 + static_cast<GLenum>(unit)) {
    if (gl_.guard != nullptr) {
        gl_.guard->textureUnits().use(unit, GL_TEXTURE_2D);
    }
    gl_.ActiveTexture(unit_);
    gl_.GetIntegerv(GL_TEXTURE_BINDING_2D_MULTISAMPLE, &before_);
    gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
}

MultisampleBinding::~MultisampleBinding() {
    gl_.ActiveTexture(unit_);
    gl_.BindTexture(GL_TEXTURE_2D_MULTISAMPLE, static_cast<GLuint>(before_));
}

SampleMask::SampleMask(const Functions& gl) : gl_(gl) {
    gl_.GetIntegeri_v(GL_SAMPLE_MASK_VALUE, 0, &before_);
    gl_.Enable(GL_SAMPLE_MASK);
}

SampleMask::~SampleMask() {
    gl_.SampleMaski(0, static_cast<GLbitfield>(before_));
    gl_.Disable(GL_SAMPLE_MASK);
}

void SampleMask::only(int sample) const {
    gl_.SampleMaski(0, GLbitfield{1} << static_cast<unsigned>(sample));
}

} // namespace aolib::gl
