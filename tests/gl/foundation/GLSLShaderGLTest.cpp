#include "gl/GLSLShader.h"

#include "GLTest.h"
#include "backbone/frame/ShaderLibrary.h"
#include "gl/VertexArray.h"

namespace aolib::gl {
namespace {

constexpr const char* kVertex = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n";
constexpr const char* kFragment =
    "#version 330 core\nuniform float uValue;\nout vec4 colour;\nvoid main() { colour = "
    "vec4(uValue); }\n";

class GLSLShaderGLTest : public GLTest {};

TEST_P(GLSLShaderGLTest, Builds) {
    auto shader = GLSLShader::build(gl, {"a.vert", kVertex}, {"a.frag", kFragment});
    ASSERT_TRUE(shader.ok()) << shader.status().message();
    shader->bind();
    shader->set("uValue", 1.0F);
    shader->set("uNoSuchUniform", 1.0F);
    gl.UseProgram(0);
}

TEST_P(GLSLShaderGLTest, TheErrorHoldsTheStageAndTheDriversLog) {
    const auto shader = GLSLShader::build(gl, {"a.vert", kVertex},
                                          {"broken.frag", "#version 330 core\nnonsense here;\n"});
    ASSERT_EQ(shader.status().code(), StatusCode::ShaderError);
    EXPECT_NE(shader.status().message().find("broken.frag"), std::string::npos);
    EXPECT_NE(shader.status().message().find("syntax error"), std::string::npos)
        << shader.status().message();
    takeDriverMessages(); // the driver reports the failed compile there, too
}

TEST_P(GLSLShaderGLTest, LinkErrorsAreReported) {
    const auto shader = GLSLShader::build(
        gl, {"a.vert", kVertex},
        {"a.frag", "#version 330 core\nfloat missing();\nout vec4 c;\nvoid main() { c = "
                   "vec4(missing()); }\n"});
    ASSERT_EQ(shader.status().code(), StatusCode::ShaderError) << shader.status().message();
    takeDriverMessages();
}

TEST_P(GLSLShaderGLTest, EmbeddedShadersKnowTheirFiles) {
    ASSERT_GT(kEmbeddedShaderCount, 10U);
    for (std::size_t i = 0; i < kEmbeddedShaderCount; ++i) {
        const EmbeddedShader& shader = kEmbeddedShaders[i];
        EXPECT_EQ(shader.text.substr(0, 17), "#version 330 core") << shader.name;
        EXPECT_EQ(shader.text.find("#include \""), std::string_view::npos) << shader.name;
        EXPECT_EQ(shader.files.substr(0, shader.name.size()), shader.name);
    }
    EXPECT_EQ(buildShader(gl, "fullscreen.vert", "no/such.frag").status().code(),
              StatusCode::ShaderError);
}

AOLIB_FOR_ALL_CONTEXTS(GLSLShaderGLTest);

} // namespace
} // namespace aolib::gl
