#include "viewer/TracedPicture.h"

#include <utility>

#include "viewer/ViewerShaders.h"

namespace aolib::viewer {

Result<TracedPicture> TracedPicture::create(const gl::Functions& gl) {
    TracedPicture made;
    made.gl_ = &gl;
    Result<gl::GLSLShader> shader = gl::GLSLShader::build(gl, {"whole.vert", wholeVertexShader},
                                                          {"traced.frag", tracedFragmentShader});
    if (!shader) {
        return shader.status();
    }
    made.shader_ = std::move(*shader);
    made.empty_ = gl::generate<gl::VertexArrayName>(gl, &gl::Functions::GenVertexArrays);
    made.texture_ = gl::generate<gl::Texture>(gl, &gl::Functions::GenTextures);
    return made;
}

void TracedPicture::upload(const FloatImage& visibility) {
    colours_ = false;
    allocate(visibility.pixels.data(), GL_R32F, GL_RED, GL_FLOAT, visibility.width,
             visibility.height);
}

void TracedPicture::upload(const ByteImage& colours) {
    colours_ = true;
    allocate(colours.pixels.data(), GL_RGB8, GL_RGB, GL_UNSIGNED_BYTE, colours.width,
             colours.height);
}

void TracedPicture::allocate(const void* texels, GLint format, GLenum layout, GLenum type,
                             int width, int height) {
    gl_->ActiveTexture(GL_TEXTURE0);
    gl_->BindTexture(GL_TEXTURE_2D, texture_.name());
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl_->BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_->TexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, layout, type, texels);
    gl_->BindTexture(GL_TEXTURE_2D, 0);
}

void TracedPicture::darken(float contrast) {
    gl_->Enable(GL_BLEND);
    gl_->BlendEquation(GL_FUNC_ADD);
    gl_->BlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
    draw(contrast);
    gl_->Disable(GL_BLEND);
}

void TracedPicture::show() {
    gl_->Disable(GL_BLEND);
    draw(1.0F);
}

void TracedPicture::draw(float contrast) {
    gl_->Disable(GL_DEPTH_TEST);
    shader_.bind();
    gl_->ActiveTexture(GL_TEXTURE0);
    gl_->BindTexture(GL_TEXTURE_2D, texture_.name());
    shader_.set("picture", 0);
    shader_.set("colours", colours_ ? 1 : 0);
    shader_.set("contrast", contrast);
    gl_->BindVertexArray(empty_.name());
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
    gl_->BindVertexArray(0);
    gl_->BindTexture(GL_TEXTURE_2D, 0);
    gl_->UseProgram(0);
}

} // namespace aolib::viewer
