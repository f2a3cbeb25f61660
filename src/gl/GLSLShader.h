#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <aolib/Status.h>

#include "gl/Functions.h"

namespace aolib::gl {

/// A program of a vertex and a fragment stage (thesis 4.2.3).
class GLSLShader {
public:
    /// The text of one stage and the name that messages give it.
    struct Source {
        std::string_view name;
        std::string_view text;
    };

    GLSLShader() = default;
    GLSLShader(GLSLShader&& other) noexcept;
    GLSLShader& operator=(GLSLShader&& other) noexcept;
    ~GLSLShader();

    /// Compiles and links. Fragment outputs carry their locations in the source.
    /// Errors: ShaderError with the stage's name and the driver's log, OutOfMemory.
    static Result<GLSLShader> build(const Functions& gl, const Source& vertex,
                                    const Source& fragment);

    void bind() const;

    // Uniforms of the bound program. A name that the program does not use is ignored, as GL does.
    void set(const char* name, int value);
    void set(const char* name, float value);
    void set(const char* name, const glm::ivec2& value);
    void set(const char* name, const glm::vec2& value);
    void set(const char* name, const glm::vec3& value);
    void set(const char* name, const glm::vec4& value);
    void set(const char* name, std::span<const float> values);
    void set(const char* name, std::span<const glm::vec4> values);
    void set(const char* name, std::span<const glm::ivec4> values);
    void set(const char* name, const glm::mat3& value);
    void set(const char* name, const glm::mat4& value);

private:
    GLint location(const char* name);

    const Functions* gl_ = nullptr;
    GLuint program_ = 0;
    std::map<std::string, GLint, std::less<>> locations_;
};

} // namespace aolib::gl
