#include "HostObjects.h"

#include <cstdint>
#include <stdexcept>
#include <string>

namespace aolib {

namespace {

constexpr std::size_t kOfEach = 3;

/// What every word of a buffer holds.
GLuint pattern(GLuint name) {
    return 0xC0FFEE00U + name;
}

GLuint compile(const HostGl& gl, GLenum kind, const char* text) {
    const GLuint shader = gl.CreateShader(kind);
    gl.ShaderSource(shader, 1, &text, nullptr);
    gl.CompileShader(shader);
    return shader;
}

GLuint link(const HostGl& gl, const char* vertex, const char* varying) {
    const GLuint program = gl.CreateProgram();
    const GLuint vertexShader = compile(gl, GL_VERTEX_SHADER, vertex);
    const GLuint fragmentShader = compile(gl, GL_FRAGMENT_SHADER,
                                          "#version 330 core\nuniform vec4 colour;\nout vec4 c;\n"
                                          "void main() { c = colour; }\n");
    gl.AttachShader(program, vertexShader);
    gl.AttachShader(program, fragmentShader);
    gl.DeleteShader(vertexShader);
    gl.DeleteShader(fragmentShader);
    if (varying != nullptr) {
        gl.TransformFeedbackVaryings(program, 1, &varying, GL_INTERLEAVED_ATTRIBS);
    }
    gl.LinkProgram(program);
    GLint linked = GL_FALSE;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        throw std::runtime_error("a shader of the tests does not link");
    }
    gl.UseProgram(program);
    gl.Uniform4f(gl.GetUniformLocation(program, "colour"), 0.1F, 0.2F, 0.3F, 0.4F);
    gl.UseProgram(0);
    return program;
}

} // namespace

HostObjects::HostObjects(const HostGl& gl) : gl_(gl) {
    makeBuffers();
    makeTextures();
    makeSamplers();
    makeVertexArrays();
    makePrograms();
    makeQueries();
    makeFramebuffers();
}

HostObjects::~HostObjects() {
    const auto remove = [](auto function, std::vector<GLuint>& names) {
        if (!names.empty()) {
            function(static_cast<GLsizei>(names.size()), names.data());
        }
    };
    for (auto& [target, names] : textures) {
        remove(gl_.DeleteTextures, names);
    }
    remove(gl_.DeleteTextures, ownTextures_);
    remove(gl_.DeleteSamplers, samplers);
    remove(gl_.DeleteBuffers, buffers);
    remove(gl_.DeleteBuffers, feedbackBuffers);
    remove(gl_.DeleteVertexArrays, vertexArrays);
    remove(gl_.DeleteRenderbuffers, renderbuffers);
    remove(gl_.DeleteTransformFeedbacks, feedbacks);
    remove(gl_.DeleteProgramPipelines, pipelines);
    for (const auto& [target, name] : queries) {
        gl_.DeleteQueries(1, &name);
    }
    gl_.DeleteQueries(1, &emptyQuery);
    gl_.DeleteFramebuffers(static_cast<GLsizei>(framebuffers_.size()), framebuffers_.data());
    for (const GLuint name : {program, feedbackProgram, fragmentProgram}) {
        gl_.DeleteProgram(name);
    }
}

void HostObjects::makeTextures() {
    const GLuint store = buffers.front();
    std::vector<GLenum> targets{GL_TEXTURE_1D,
                                GL_TEXTURE_2D,
                                GL_TEXTURE_3D,
                                GL_TEXTURE_1D_ARRAY,
                                GL_TEXTURE_2D_ARRAY,
                                GL_TEXTURE_RECTANGLE,
                                GL_TEXTURE_CUBE_MAP,
                                GL_TEXTURE_BUFFER,
                                GL_TEXTURE_2D_MULTISAMPLE,
                                GL_TEXTURE_2D_MULTISAMPLE_ARRAY};
    if (gl_.has.cubeMapArray) {
        targets.push_back(GL_TEXTURE_CUBE_MAP_ARRAY);
    }
    for (const GLenum target : targets) {
        std::vector<GLuint>& names = textures[target];
        names.resize(kOfEach);
        gl_.GenTextures(kOfEach, names.data());
        for (const GLuint name : names) {
            gl_.BindTexture(target, name);
            const GLint format = GL_RGBA8;
            const auto flat = [&](GLenum face, GLsizei height) {
                const std::vector<GLuint> content(std::size_t{8} * 8, pattern(name));
                gl_.TexImage2D(face, 0, format, 8, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                               content.data());
            };
            if (target == GL_TEXTURE_1D) {
                gl_.TexImage1D(target, 0, format, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
            } else if (target == GL_TEXTURE_2D || target == GL_TEXTURE_RECTANGLE ||
                       target == GL_TEXTURE_1D_ARRAY) {
                flat(target, 4);
            } else if (target == GL_TEXTURE_CUBE_MAP) {
                for (GLenum face = 0; face < 6; ++face) {
                    flat(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 8);
                }
            } else if (target == GL_TEXTURE_BUFFER) {
                gl_.TexBuffer(target, GL_RGBA8, store);
            } else if (target == GL_TEXTURE_2D_MULTISAMPLE) {
                gl_.TexImage2DMultisample(target, 4, GL_RGBA8, 8, 8, GL_TRUE);
            } else if (target == GL_TEXTURE_2D_MULTISAMPLE_ARRAY) {
                gl_.TexImage3DMultisample(target, 4, GL_RGBA8, 8, 8, 2, GL_TRUE);
            } else {
                gl_.TexImage3D(target, 0, format, 8, 8, 6, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
            }
        }
        gl_.BindTexture(target, 0);
    }
}

void HostObjects::makeSamplers() {
    samplers.resize(kOfEach);
    gl_.GenSamplers(kOfEach, samplers.data());
    for (const GLuint name : samplers) {
        // Any of these would spoil a pass that reads through it.
        gl_.SamplerParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
        gl_.SamplerParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        gl_.SamplerParameteri(name, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
        gl_.SamplerParameteri(name, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        gl_.SamplerParameterf(name, GL_TEXTURE_LOD_BIAS, 2.0F);
        gl_.SamplerParameterf(name, GL_TEXTURE_MIN_LOD, 1.0F);
    }
}

void HostObjects::makeBuffers() {
    const auto make = [&](std::vector<GLuint>& names, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            GLuint name = 0;
            gl_.GenBuffers(1, &name);
            gl_.BindBuffer(GL_ARRAY_BUFFER, name);
            const std::vector<GLuint> content(kBufferBytes / sizeof(GLuint), pattern(name));
            gl_.BufferData(GL_ARRAY_BUFFER, kBufferBytes, content.data(), GL_DYNAMIC_DRAW);
            names.push_back(name);
        }
    };
    make(buffers, 6);
    make(feedbackBuffers, kOfEach);
    gl_.BindBuffer(GL_ARRAY_BUFFER, 0);
    if (gl_.has.transformFeedback2) {
        feedbacks.resize(kOfEach);
        gl_.GenTransformFeedbacks(kOfEach, feedbacks.data());
    }
}

void HostObjects::makeVertexArrays() {
    vertexArrays.resize(kOfEach);
    gl_.GenVertexArrays(kOfEach, vertexArrays.data());
    for (std::size_t i = 0; i < kOfEach; ++i) {
        gl_.BindVertexArray(vertexArrays[i]);
        gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[i]);
        for (GLuint location = 0; location < 3 + i; ++location) {
            gl_.BindBuffer(GL_ARRAY_BUFFER, buffers[(i + location) % buffers.size()]);
            gl_.EnableVertexAttribArray(location);
            const void* offset = reinterpret_cast<const void*>(std::uintptr_t{8} * location);
            if (location == 2) {
                gl_.VertexAttribIPointer(location, 3, GL_INT, 16, offset);
            } else {
                gl_.VertexAttribPointer(location, 2, GL_SHORT, GL_TRUE, 12, offset);
            }
            gl_.VertexAttribDivisor(location, location);
        }
    }
    gl_.BindVertexArray(0);
    gl_.BindBuffer(GL_ARRAY_BUFFER, 0);
}

void HostObjects::makePrograms() {
    program = link(gl_, "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n", nullptr);
    feedbackProgram = link(gl_,
                           "#version 330 core\nout vec4 captured;\n"
                           "void main() { captured = vec4(1.0); gl_Position = vec4(0.0); }\n",
                           "captured");
    if (gl_.has.separatePrograms) {
        const char* text = "#version 330 core\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n";
        fragmentProgram = gl_.CreateShaderProgramv(GL_FRAGMENT_SHADER, 1, &text);
        pipelines.resize(kOfEach);
        gl_.GenProgramPipelines(kOfEach, pipelines.data());
        for (const GLuint name : pipelines) {
            gl_.UseProgramStages(name, GL_FRAGMENT_SHADER_BIT, fragmentProgram);
        }
    }
}

void HostObjects::makeQueries() {
    std::vector<GLenum> targets{GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED, GL_PRIMITIVES_GENERATED,
                                GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, GL_TIME_ELAPSED};
    if (gl_.has.conservativeQuery) {
        targets.push_back(GL_ANY_SAMPLES_PASSED_CONSERVATIVE);
    }
    for (const GLenum target : targets) {
        gl_.GenQueries(1, &queries[target]);
        gl_.BeginQuery(target, queries[target]); // a query exists from its first use
        gl_.EndQuery(target);
    }
    gl_.GenQueries(1, &emptyQuery);
    gl_.BeginQuery(GL_SAMPLES_PASSED, emptyQuery);
    gl_.EndQuery(GL_SAMPLES_PASSED);
}

std::string HostObjects::damage() const {
    std::string damaged;
    for (const GLuint name : textures.at(GL_TEXTURE_2D)) {
        std::vector<GLuint> content(std::size_t{8} * 4);
        gl_.BindTexture(GL_TEXTURE_2D, name);
        gl_.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, content.data());
        if (content != std::vector<GLuint>(content.size(), pattern(name))) {
            damaged.append(" texture ").append(std::to_string(name));
        }
    }
    gl_.BindTexture(GL_TEXTURE_2D, 0);
    for (const std::vector<GLuint>* names : {&buffers, &feedbackBuffers}) {
        for (const GLuint name : *names) {
            std::vector<GLuint> content(kBufferBytes / sizeof(GLuint));
            gl_.BindBuffer(GL_COPY_READ_BUFFER, name);
            gl_.GetBufferSubData(GL_COPY_READ_BUFFER, 0, kBufferBytes, content.data());
            if (content != std::vector<GLuint>(content.size(), pattern(name))) {
                damaged.append(" buffer ").append(std::to_string(name));
            }
        }
    }
    gl_.BindBuffer(GL_COPY_READ_BUFFER, 0);
    return damaged;
}

} // namespace aolib
