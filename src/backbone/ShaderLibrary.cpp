#include "backbone/ShaderLibrary.h"

#include <algorithm>
#include <string>

namespace aolib {

namespace {

const EmbeddedShader* find(std::string_view name) {
    const EmbeddedShader* end = kEmbeddedShaders + kEmbeddedShaderCount;
    const EmbeddedShader* found =
        std::find_if(kEmbeddedShaders, end, [&](const auto& s) { return s.name == name; });
    return found == end ? nullptr : found;
}

} // namespace

Result<gl::GLSLShader> buildShader(const gl::Functions& gl, std::string_view vertex,
                                   std::string_view fragment) {
    const EmbeddedShader* vertexStage = find(vertex);
    const EmbeddedShader* fragmentStage = find(fragment);
    if (vertexStage == nullptr || fragmentStage == nullptr) {
        return Status(StatusCode::ShaderError,
                      std::string(vertexStage == nullptr ? vertex : fragment) +
                          " was not embedded; name it in src/backbone/CMakeLists.txt");
    }
    Result<gl::GLSLShader> built = gl::GLSLShader::build(
        gl, {vertexStage->name, vertexStage->text}, {fragmentStage->name, fragmentStage->text});
    if (!built && built.status().code() == StatusCode::ShaderError) {
        return Status(StatusCode::ShaderError,
                      built.status().message() + "\nfiles of " + std::string(vertex) +
                          " in order: " + std::string(vertexStage->files) + "; of " +
                          std::string(fragment) + ": " + std::string(fragmentStage->files));
    }
    return built;
}

} // namespace aolib
