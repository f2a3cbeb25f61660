#pragma once

#include <aolib/Status.h>

#include "gl/GLSLShader.h"
#include "gl/Handle.h"
#include "image/Image.h"

namespace aolib::viewer {

/// A picture that was computed on the CPU, drawn over the viewport, whose size it must have.
/// Context: the one current at create(), for every call.
class TracedPicture {
public:
    /// @param gl  must outlive it. Errors: ShaderError.
    static Result<TracedPicture> create(const gl::Functions& gl);

    /// Takes W of one channel, background -1.
    void upload(const FloatImage& visibility);
    /// Takes colours of three channels.
    void upload(const ByteImage& colours);

    /// Darkens what is there by W, as the library does. @param contrast  0 to 1.
    void darken(float contrast);
    /// Draws W in grey, the background white; or the colours.
    void show();

private:
    void allocate(const void* texels, GLint format, GLenum layout, GLenum type, int width,
                  int height);
    void draw(float contrast);

    const gl::Functions* gl_ = nullptr;
    gl::GLSLShader shader_;
    gl::VertexArrayName empty_;
    gl::Texture texture_;
    bool colours_ = false;
};

} // namespace aolib::viewer
