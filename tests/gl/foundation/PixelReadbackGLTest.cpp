#include "gl/PixelReadback.h"

#include <array>

#include "GLTest.h"
#include "gl/GpuTimer.h"
#include "gl/RenderToTexture2D.h"

namespace aolib::gl {
namespace {

class PixelReadbackGLTest : public GLTest {};

TEST_P(PixelReadbackGLTest, BringsThePixelsOnce) {
    const auto target = RenderToTexture2D::create(
        gl,
        {.width = 2, .height = 2, .targets = {RenderToTexture2D::Format::RG8}, .label = "test"});
    ASSERT_TRUE(target.ok());
    auto readback = PixelReadback::create(gl, 8, "test");
    ASSERT_TRUE(readback.ok());
    const std::array<float, 4> colour{1.0F, 0.2F, 0.0F, 0.0F};
    target->bindAsTarget(0);
    gl.ClearBufferfv(GL_COLOR, 0, colour.data());
    target->bindForReading(0);
    const auto fail = [](std::span<const std::uint8_t>) { FAIL() << "nothing was started"; };
    EXPECT_FALSE(readback->poll(fail));
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
    readback->start(2, 2, GL_RG, GL_UNSIGNED_BYTE);
    EXPECT_TRUE(readback->pending());
    gl.Finish();
    std::vector<std::uint8_t> bytes;
    EXPECT_TRUE(readback->poll(
        [&](std::span<const std::uint8_t> data) { bytes.assign(data.begin(), data.end()); }));
    EXPECT_EQ(bytes, (std::vector<std::uint8_t>{255, 51, 255, 51, 255, 51, 255, 51}));
    EXPECT_FALSE(readback->pending());
    EXPECT_FALSE(readback->poll(fail));
}

TEST_P(PixelReadbackGLTest, TimersAnswerAfterwards) {
    auto timer = GpuTimer::create(gl);
    ASSERT_TRUE(timer.ok());
    EXPECT_EQ(timer->milliseconds(), -1.0);
    timer->begin();
    timer->end();
    gl.Finish();
    EXPECT_GE(timer->milliseconds(), 0.0);
}

AOLIB_FOR_ALL_CONTEXTS(PixelReadbackGLTest);

} // namespace
} // namespace aolib::gl
