#include "bake/gpu/BakeShaders.h"

#include <algorithm>
#include <string>

namespace aolib::bake {

namespace {

const BakeShader* find(std::string_view name) {
    const BakeShader* end = kBakeShaders + kBakeShaderCount;
    const BakeShader* found =
        std::find_if(kBakeShaders, end, [&](const BakeShader& s) { return s.name == name; });
    return found == end ? nullptr : found;
}

} // namespace

Result<gl::GLSLShader> buildBakeShader(const gl::Functions& gl, std::string_view vertex,
                                       std::string_view fragment) {
    const BakeShader* first = find(vertex);
    const BakeShader* second = find(fragment);
    if (first == nullptr || second == nullptr) {
        return AoStatus(StatusCode::ShaderError,
                        std::string(first == nullptr ? vertex : fragment) +
                            " was not embedded; name it in src/bake/CMakeLists.txt");
    }
    return gl::GLSLShader::build(gl, {first->name, first->text}, {second->name, second->text});
}

} // namespace aolib::bake
