#include "backbone/frame/ShaderLibrary.h"

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
                                   std::string_view fragment,
                                   std::initializer_list<std::string_view> defines) {
    const EmbeddedShader* vertexStage = find(vertex);
    const EmbeddedShader* fragmentStage = find(fragment);
    if (vertexStage == nullptr || fragmentStage == nullptr) {
        return AoStatus(StatusCode::ShaderError,
                        std::string(vertexStage == nullptr ? vertex : fragment) +
                            " was not embedded; name it in src/backbone/CMakeLists.txt");
    }
    std::string text(fragmentStage->text);
    if (defines.size() > 0) { // behind the line of the version, whose number stays
        std::string lines;
        for (const std::string_view define : defines) {
            lines += define.empty() ? "" : "#define " + std::string(define) + "\n";
        }
        text.insert(text.find('\n') + 1, lines + "#line 2 0\n");
    }
    Result<gl::GLSLShader> built = gl::GLSLShader::build(gl, {vertexStage->name, vertexStage->text},
                                                         {fragmentStage->name, text});
    if (!built && built.status().code() == StatusCode::ShaderError) {
        return AoStatus(StatusCode::ShaderError,
                        built.status().message() + "\nfiles of " + std::string(vertex) +
                            " in order: " + std::string(vertexStage->files) + "; of " +
                            std::string(fragment) + ": " + std::string(fragmentStage->files));
    }
    return built;
}

} // namespace aolib
