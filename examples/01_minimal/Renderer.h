#pragma once

#include <string>

#include <GL/glcorearb.h>
#include <glm/mat4x4.hpp>

#include "Boxes.h"
#include "Display.h"

/// The host's own renderer: one shader, one mesh, a light from above. It knows nothing of aolib.
class Renderer {
public:
    /// @param width,height  of framebuffer 0, pixels.
    /// Throws std::runtime_error with the driver's log when the shader does not build.
    Renderer(Display::GetProcAddress load, const Triangles& scene, int width, int height);

    /// Draws a frame to framebuffer 0.
    void draw(const glm::mat4& view, const glm::mat4& projection) const;
    /// Writes framebuffer 0 as a PPM file. @return whether the file could be written.
    bool save(const std::string& path) const;

private:
    /// The functions of OpenGL that it needs.
    struct Functions {
        PFNGLATTACHSHADERPROC attachShader;
        PFNGLBINDBUFFERPROC bindBuffer;
        PFNGLBINDVERTEXARRAYPROC bindVertexArray;
        PFNGLBUFFERDATAPROC bufferData;
        PFNGLCLEARPROC clear;
        PFNGLCLEARCOLORPROC clearColor;
        PFNGLCOMPILESHADERPROC compileShader;
        PFNGLCREATEPROGRAMPROC createProgram;
        PFNGLCREATESHADERPROC createShader;
        PFNGLDRAWELEMENTSPROC drawElements;
        PFNGLENABLEPROC enable;
        PFNGLENABLEVERTEXATTRIBARRAYPROC enableVertexAttribArray;
        PFNGLGENBUFFERSPROC genBuffers;
        PFNGLGENVERTEXARRAYSPROC genVertexArrays;
        PFNGLGETPROGRAMINFOLOGPROC getProgramInfoLog;
        PFNGLGETPROGRAMIVPROC getProgramiv;
        PFNGLGETUNIFORMLOCATIONPROC getUniformLocation;
        PFNGLLINKPROGRAMPROC linkProgram;
        PFNGLPIXELSTOREIPROC pixelStorei;
        PFNGLREADPIXELSPROC readPixels;
        PFNGLSHADERSOURCEPROC shaderSource;
        PFNGLUNIFORMMATRIX4FVPROC uniformMatrix4fv;
        PFNGLUSEPROGRAMPROC useProgram;
        PFNGLVERTEXATTRIBPOINTERPROC vertexAttribPointer;
        PFNGLVIEWPORTPROC viewport;
    };

    static Functions loadFunctions(Display::GetProcAddress load);
    void buildShader();
    void upload(const Triangles& scene);
    void uploadAttribute(GLuint location, const std::vector<glm::vec3>& values) const;

    Functions gl_;
    GLuint program_ = 0;
    GLint worldToClip_ = -1;
    GLuint vertices_ = 0;
    GLsizei indexCount_;
    int width_;
    int height_;
};
