#pragma once

#include <cstddef>
#include <initializer_list>
#include <string_view>

#include <aolib/Status.h>

#include "gl/GLSLShader.h"

namespace aolib {

/// One shader stage as the build embeds it, includes resolved.
struct EmbeddedShader {
    std::string_view name;  ///< path below shaders/
    std::string_view files; ///< the files it was made of; `#line` numbers them from 0
    std::string_view text;
};

extern const EmbeddedShader kEmbeddedShaders[];
extern const std::size_t kEmbeddedShaderCount;

/// Builds a program from two embedded stages, named by their paths.
/// @param defines  names that the fragment stage finds defined; empty ones are left out.
/// Errors: ShaderError with the driver's log and the names of the files that it numbers.
Result<gl::GLSLShader> buildShader(const gl::Functions& gl, std::string_view vertex,
                                   std::string_view fragment,
                                   std::initializer_list<std::string_view> defines = {});

} // namespace aolib
