#pragma once

#include <cstddef>
#include <string_view>

#include <aolib/Status.h>

#include "gl/GLSLShader.h"

namespace aolib {

/// One shader stage of the bakers as the build embeds it, includes resolved.
struct BakeShader {
    std::string_view name;  ///< path below shaders/
    std::string_view files; ///< the files it was made of; `#line` numbers them from 0
    std::string_view text;
};

extern const BakeShader kBakeShaders[];
extern const std::size_t kBakeShaderCount;

namespace bake {

/// Builds a program from two stages, named by their paths. Errors: ShaderError, OutOfMemory.
Result<gl::GLSLShader> buildBakeShader(const gl::Functions& gl, std::string_view vertex,
                                       std::string_view fragment);

} // namespace bake

} // namespace aolib
