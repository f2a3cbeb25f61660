// What all GL tests are watched by sees a feedback loop, and none where there is none.
#include "GLTest.h"
#include "gl/GLSLShader.h"
#include "gl/RenderToTexture2D.h"
#include "gl/TextureStack.h"
#include "gl/VertexArray.h"

namespace aolib::gl {
namespace {

using Format = RenderToTexture2D::Format;
using Depth = RenderToTexture2D::Depth;

constexpr const char* kWhole = "#version 330 core\nvoid main() { gl_Position = vec4("
                               "vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }";

class FeedbackWatchGLTest : public GLTest {
protected:
    void draw(GLSLShader& shader) {
        shader.bind();
        const auto empty = VertexArray::createEmpty(gl, "empty");
        empty->drawFullscreen();
    }
    /// A shader, bound, that could read what `read` says.
    GLSLShader shaderWith(const std::string& samplers, const std::string& read) {
        auto shader = GLSLShader::build(gl, {"whole.vert", kWhole},
                                        {"read.frag", "#version 330 core\n" + samplers +
                                                          "uniform int never;\nout vec4 colour;\n"
                                                          "void main() { colour = never == 1 ? " +
                                                          read + " : vec4(0); }"});
        EXPECT_TRUE(shader.ok()) << shader.status().message();
        shader->bind();
        return std::move(*shader);
    }
    RenderToTexture2D target(Depth depth = Depth::None) {
        auto made = RenderToTexture2D::create(gl, {.width = 4,
                                                   .height = 4,
                                                   .targets = {Format::RGBA8, Format::RGBA8},
                                                   .depth = depth,
                                                   .label = "test"});
        EXPECT_TRUE(made.ok()) << made.status().message();
        return std::move(*made);
    }
};

TEST_P(FeedbackWatchGLTest, SeesATextureThatIsDrawnToAndBound) {
    GLSLShader shader = shaderWith("uniform sampler2D one;\nuniform sampler2D two;\n",
                                   "texelFetch(one, ivec2(0), 0) + texelFetch(two, ivec2(0), 0)");
    shader.set("one", 3);
    shader.set("two", 5);
    const RenderToTexture2D drawn = target();
    const RenderToTexture2D other = target();
    drawn.bindAsTarget(0);
    other.bindTexture(0, 3);
    other.bindTexture(1, 5);
    drawn.bindTexture(0, 4); // which nothing reads
    draw(shader);
    EXPECT_EQ(takeFeedbackLoops(), "");
    drawn.bindTexture(0, 5);
    draw(shader);
    EXPECT_NE(takeFeedbackLoops().find("by two"), std::string::npos);
    drawn.bindTexture(1, 5); // attached, though not drawn to
    draw(shader);
    EXPECT_NE(takeFeedbackLoops(), "");
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

TEST_P(FeedbackWatchGLTest, SeesDepthArraysAndLayers) {
    GLSLShader depth =
        shaderWith("uniform sampler2D depths[2];\n", "texelFetch(depths[1], ivec2(0), 0)");
    depth.set("depths[0]", 0);
    depth.set("depths[1]", 1);
    const RenderToTexture2D drawn = target(Depth::Depth24);
    const RenderToTexture2D other = target();
    drawn.bindAsTarget(0);
    other.bindTexture(0, 0);
    drawn.bindDepthTexture(1);
    draw(depth);
    EXPECT_NE(takeFeedbackLoops(), "");
    GLSLShader layers =
        shaderWith("uniform sampler2DArray layers;\n", "texelFetch(layers, ivec3(0), 0)");
    layers.set("layers", 2);
    const auto stack = TextureStack::create(
        gl, {.width = 4, .height = 4, .layers = 2, .format = Format::RGBA8, .label = "stack"});
    ASSERT_TRUE(stack.ok());
    stack->bindAsTarget(1);
    stack->bind(2);
    draw(layers);
    EXPECT_NE(takeFeedbackLoops(), "");
    drawn.bindAsTarget(0);
    draw(layers);
    EXPECT_EQ(takeFeedbackLoops(), "");
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

AOLIB_FOR_ALL_CONTEXTS(FeedbackWatchGLTest);

} // namespace
} // namespace aolib::gl
