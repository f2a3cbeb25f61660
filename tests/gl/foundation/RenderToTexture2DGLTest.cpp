#include "gl/RenderToTexture2D.h"

#include <array>

#include "GLTest.h"

namespace aolib::gl {
namespace {

using Format = RenderToTexture2D::Format;
using Depth = RenderToTexture2D::Depth;

class RenderToTexture2DGLTest : public GLTest {
protected:
    std::array<float, 4> readPixel(const RenderToTexture2D& target, int index) const {
        std::array<float, 4> pixel{};
        target.bindForReading(index);
        gl.ReadPixels(1, 1, 1, 1, GL_RGBA, GL_FLOAT, pixel.data());
        return pixel;
    }
};

TEST_P(RenderToTexture2DGLTest, EachTargetKeepsItsOwnContent) {
    const auto target = RenderToTexture2D::create(gl, {.width = 4,
                                                       .height = 4,
                                                       .targets = {Format::RGBA32F, Format::R8},
                                                       .depth = Depth::Depth32F,
                                                       .label = "test"});
    ASSERT_TRUE(target.ok()) << target.status().message();
    const std::array<float, 4> first{1.5F, -2.0F, 300.0F, 0.25F};
    const std::array<float, 4> second{1.0F, 0.0F, 0.0F, 0.0F};
    target->bindAllAsTargets();
    gl.ClearBufferfv(GL_COLOR, 0, first.data());
    gl.ClearBufferfv(GL_COLOR, 1, second.data());
    EXPECT_EQ(readPixel(*target, 0), first);
    EXPECT_EQ(readPixel(*target, 1)[0], 1.0F);
    const std::array<float, 4> third{0.0F, 0.0F, 0.0F, 0.0F};
    target->bindAsTarget(1);
    gl.ClearBufferfv(GL_COLOR, 0, third.data());
    EXPECT_EQ(readPixel(*target, 0), first) << "begin(1) must leave target 0 alone";
    EXPECT_EQ(readPixel(*target, 1)[0], 0.0F);
}

TEST_P(RenderToTexture2DGLTest, EveryFormatKeepsItsChannels) {
    const struct {
        Format format;
        int channels;
        float tolerance; // half a step of the channel; a whole one of half floats, which llvmpipe
                         // cuts off
    } cases[] = {{Format::R8, 1, 0.002F},   {Format::RG8, 2, 0.002F},    {Format::RGBA8, 4, 0.002F},
                 {Format::R16, 1, 1e-5F},   {Format::RG16, 2, 1e-5F},    {Format::R16F, 1, 5e-4F},
                 {Format::RG16F, 2, 5e-4F}, {Format::RGBA16F, 4, 5e-4F}, {Format::R32F, 1, 0.0F},
                 {Format::RG32F, 2, 0.0F},  {Format::RGBA32F, 4, 0.0F}};
    const std::array<float, 4> written{0.3F, 0.6F, 0.1F, 0.9F};
    for (const auto& c : cases) {
        const auto target = RenderToTexture2D::create(
            gl, {.width = 4, .height = 4, .targets = {c.format}, .label = "test"});
        ASSERT_TRUE(target.ok()) << target.status().message();
        target->bindAsTarget(0);
        gl.ClearBufferfv(GL_COLOR, 0, written.data());
        const std::array<float, 4> read = readPixel(*target, 0);
        for (int i = 0; i < c.channels; ++i) {
            EXPECT_NEAR(read[static_cast<std::size_t>(i)], written[static_cast<std::size_t>(i)],
                        c.tolerance);
        }
        EXPECT_EQ(target->bytes(), 16 * RenderToTexture2D::bytesPerTexel(c.format));
    }
}

TEST_P(RenderToTexture2DGLTest, ImpossibleSizesAreRefused) {
    for (const int width : {0, -1, gl.capabilities.maxTextureSize + 1}) {
        const auto target = RenderToTexture2D::create(
            gl, {.width = width, .height = 4, .targets = {Format::R8}, .label = "test"});
        EXPECT_EQ(target.status().code(), StatusCode::MissingCapability) << width;
    }
}

AOLIB_FOR_ALL_CONTEXTS(RenderToTexture2DGLTest);

} // namespace
} // namespace aolib::gl
