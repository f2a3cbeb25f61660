// The window's pictures are those that "aolib render" makes without one.
#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "WindowTest.h"
#include "image/Png.h"

namespace aolib::test {

namespace {

using nlohmann::json;

double meanBrightness(const ByteImage& image, int x0, int x1, int y0, int y1) {
    double sum = 0.0;
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
            sum += image.at(x, y, 0) + image.at(x, y, 1) + image.at(x, y, 2);
        }
    }
    return sum / (3.0 * (x1 - x0) * (y1 - y0));
}

/// The largest difference of any channel in a part of two pictures.
int worstDifference(const ByteImage& a, const ByteImage& b, int x0, int x1, int y0, int y1) {
    int worst = 0;
    for (int y = y0; y < y1; ++y) {
        for (int x = x0; x < x1; ++x) {
            for (int c = 0; c < 3; ++c) {
                worst = std::max(worst, std::abs(int{a.at(x, y, c)} - int{b.at(x, y, c)}));
            }
        }
    }
    return worst;
}

class WindowPictureGLTest : public WindowTest {
protected:
    ByteImage picture(const std::string& name) const {
        Result<ByteImage, ImageError> read = readPng(path(name));
        EXPECT_TRUE(read) << name;
        return read ? *read : ByteImage(1, 1, 3);
    }
};

/// What the window shows is what "aolib render" draws of the case that it saves.
TEST_F(WindowPictureGLTest, ACaseGivesTheSamePictureWithoutAWindow) {
    start({"room", "--width", "300", "--height", "200", "--no-panel", "--compare", "host",
           "--estimator", "ray-traced", "--texel-rays", "4", "--no-repair", "--face-size", "32",
           "--screenshot", "shown.png"});
    drag(60, 100, 70, 104);
    waitForRest();
    key("F11");
    waitFor("a case", [](const json& s) {
        return s["message"].get<std::string>().find("saved") != std::string::npos;
    });
    input({"sleep", "6.5"}); // the message goes
    waitForRest();
    quit();

    std::istringstream log(bytesOf("log"));
    std::vector<std::string> words;
    for (std::string line; std::getline(log, line);) {
        if (line.starts_with("aolib render ")) {
            std::istringstream command(line.substr(std::string("aolib ").size()));
            for (std::string word; command >> word;) {
                words.push_back(word);
            }
        }
    }
    ASSERT_FALSE(words.empty()) << bytesOf("log");
    words.insert(words.end(), {"--colour", "colour.png", "--composite", "composite.png"});
    const ProgramRun rendered = run(words);
    ASSERT_EQ(rendered.exitCode, 0) << rendered.err;
    const ByteImage shown = picture("shown.png");
    const ByteImage composite = picture("composite.png");
    const ByteImage colour = picture("colour.png");
    ASSERT_EQ(shown.width, 300);
    ASSERT_EQ(shown.height, 200);
    // Without the labels at the top and the line in the middle; rounding of the last bit.
    EXPECT_LE(worstDifference(shown, composite, 0, 140, 0, 160), 1);
    EXPECT_LE(worstDifference(shown, colour, 160, 300, 0, 160), 1);
    EXPECT_LT(meanBrightness(composite, 0, 300, 0, 200),
              meanBrightness(colour, 0, 300, 0, 200) - 2);
}

/// What the right part shows is what "aolib render" lights, until another environment is dropped.
TEST_F(WindowPictureGLTest, AnEnvironmentLightsTheSceneAsRenderDoes) {
    const std::vector<std::string> light{"--environment", "overcast", "--turn",     "30",
                                         "--lit-rays",    "16",       "--lit-edge", "10",
                                         "--width",       "300",      "--height",   "200"};
    start(with({"wall", "--no-panel", "--split", "0.1", "--texel-rays", "4", "--face-size", "16",
                "--estimator", "ray-traced", "--no-repair", "--gl-debug", "--screenshot",
                "shown.png"},
               light));
    waitFor("baked vertices", [](const json& s) { return s["light"]["vertices"] > 0; });
    EXPECT_EQ(state()["compared"], "environment");
    EXPECT_EQ(state()["environment"], "overcast");
    waitForRest();
    quit();
    const ProgramRun rendered = run(with({"render", "wall", "--lit", "lit.png"}, light));
    ASSERT_EQ(rendered.exitCode, 0) << rendered.err;
    const ByteImage shown = picture("shown.png");
    const ByteImage lit = picture("lit.png");
    ASSERT_EQ(shown.width, 300);
    EXPECT_LE(worstDifference(shown, lit, 50, 300, 0, 160), 1);
    EXPECT_GT(meanBrightness(lit, 50, 300, 0, 160), 40);
}

} // namespace

} // namespace aolib::test
