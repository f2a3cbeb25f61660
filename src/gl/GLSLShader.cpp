#include "gl/GLSLShader.h"

#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "gl/ContextGroup.h"
#include "gl/Label.h"

namespace aolib::gl {

namespace {

/// A shader object that lives until its program is linked.
class Stage {
public:
    Stage(const Functions& gl, GLenum kind) : gl_(gl), name_(gl.CreateShader(kind)) {}
    ~Stage() {
        if (name_ != 0) {
            gl_.DeleteShader(name_);
        }
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    GLuint name() const { return name_; }

    AoStatus compile(const GLSLShader::Source& source) const {
        if (name_ == 0) {
            return {StatusCode::OutOfMemory, std::string(source.name) + ": GL gave no shader name"};
        }
        const GLchar* text = source.text.data();
        const auto length = static_cast<GLint>(source.text.size());
        gl_.ShaderSource(name_, 1, &text, &length);
        gl_.CompileShader(name_);
        GLint compiled = GL_FALSE;
        gl_.GetShaderiv(name_, GL_COMPILE_STATUS, &compiled);
        if (compiled == GL_TRUE) {
            return {};
        }
        GLint size = 0;
        gl_.GetShaderiv(name_, GL_INFO_LOG_LENGTH, &size);
        std::string log(static_cast<std::size_t>(size > 0 ? size : 0), '\0');
        gl_.GetShaderInfoLog(name_, size, nullptr, log.data());
        return {StatusCode::ShaderError,
                std::string(source.name) + " does not compile: " + log.c_str()};
    }

private:
    const Functions& gl_;
    GLuint name_;
};

} // namespace

GLSLShader::GLSLShader(GLSLShader&& other) noexcept
    : gl_(other.gl_), program_(std::exchange(other.program_, 0U)),
      locations_(std::move(other.locations_)) {}

GLSLShader& GLSLShader::operator=(GLSLShader&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(program_, other.program_);
    std::swap(locations_, other.locations_);
    return *this;
}

GLSLShader::~GLSLShader() {
    if (program_ != 0) {
        release(*gl_, 0, [deleteProgram = gl_->DeleteProgram, program = program_] {
            deleteProgram(program);
        });
    }
}

Result<GLSLShader> GLSLShader::build(const Functions& gl, const Source& vertex,
                                     const Source& fragment) {
    const Stage vertexStage(gl, GL_VERTEX_SHADER);
    if (AoStatus status = vertexStage.compile(vertex); !status) {
        return status;
    }
    const Stage fragmentStage(gl, GL_FRAGMENT_SHADER);
    if (AoStatus status = fragmentStage.compile(fragment); !status) {
        return status;
    }
    GLSLShader shader;
    shader.gl_ = &gl;
    shader.program_ = gl.CreateProgram();
    if (shader.program_ == 0) {
        return AoStatus(StatusCode::OutOfMemory,
                        std::string(fragment.name) + ": GL gave no program name");
    }
    gl.AttachShader(shader.program_, vertexStage.name());
    gl.AttachShader(shader.program_, fragmentStage.name());
    gl.LinkProgram(shader.program_);
    gl.DetachShader(shader.program_, vertexStage.name());
    gl.DetachShader(shader.program_, fragmentStage.name());
    GLint linked = GL_FALSE;
    gl.GetProgramiv(shader.program_, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        GLint size = 0;
        gl.GetProgramiv(shader.program_, GL_INFO_LOG_LENGTH, &size);
        std::string log(static_cast<std::size_t>(size > 0 ? size : 0), '\0');
        gl.GetProgramInfoLog(shader.program_, size, nullptr, log.data());
        return AoStatus(StatusCode::ShaderError, std::string(vertex.name) + " and " +
                                                     std::string(fragment.name) +
                                                     " do not link: " + log.c_str());
    }
    gl::label(gl, GL_PROGRAM, shader.program_, "aolib/" + std::string(fragment.name));
    return shader;
}

void GLSLShader::bind() const {
    gl_->UseProgram(program_);
}

GLint GLSLShader::location(const char* name) {
    const auto known = locations_.find(name);
    if (known != locations_.end()) {
        return known->second;
    }
    return locations_.emplace(name, gl_->GetUniformLocation(program_, name)).first->second;
}

void GLSLShader::set(const char* name, int value) {
    gl_->Uniform1i(location(name), value);
}
void GLSLShader::set(const char* name, float value) {
    gl_->Uniform1f(location(name), value);
}
void GLSLShader::set(const char* name, const glm::ivec2& value) {
    gl_->Uniform2i(location(name), value.x, value.y);
}
void GLSLShader::set(const char* name, const glm::vec2& value) {
    gl_->Uniform2f(location(name), value.x, value.y);
}
void GLSLShader::set(const char* name, const glm::vec3& value) {
    gl_->Uniform3f(location(name), value.x, value.y, value.z);
}
void GLSLShader::set(const char* name, const glm::vec4& value) {
    gl_->Uniform4f(location(name), value.x, value.y, value.z, value.w);
}
void GLSLShader::set(const char* name, std::span<const float> values) {
    gl_->Uniform1fv(location(name), static_cast<GLsizei>(values.size()), values.data());
}
void GLSLShader::set(const char* name, std::span<const glm::vec4> values) {
    gl_->Uniform4fv(location(name), static_cast<GLsizei>(values.size()),
                    glm::value_ptr(values.front()));
}
void GLSLShader::set(const char* name, std::span<const glm::ivec4> values) {
    gl_->Uniform4iv(location(name), static_cast<GLsizei>(values.size()),
                    glm::value_ptr(values.front()));
}
void GLSLShader::set(const char* name, const glm::mat3& value) {
    gl_->UniformMatrix3fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void GLSLShader::set(const char* name, const glm::mat4& value) {
    gl_->UniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

} // namespace aolib::gl
