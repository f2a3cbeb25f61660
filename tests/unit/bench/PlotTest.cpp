#include "bench/plot/Plot.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "BenchFolder.h"
#include "bench/plot/Painter.h"
#include "bench/plot/PlotFiles.h"
#include "bench/plot/StrokeFont.h"
#include "bench/plot/SvgText.h"
#include "image/Png.h"

namespace aolib::bench {
namespace {

constexpr Colour kRed{255, 0, 0};

bool isRed(const ByteImage& image, int x, int fromTop) {
    const int y = image.height - 1 - fromTop;
    return image.at(x, y, 0) == 255 && image.at(x, y, 1) == 0 && image.at(x, y, 2) == 0;
}

Plot samplePlot() {
    Plot plot;
    plot.title = "Errors & costs";
    plot.x.title = "x";
    plot.y.title = "y";
    plot.curves.push_back({"<first>", kRed, Marker::Square, {{1, 0.1, "a"}, {10, 0.01, "b"}}});
    plot.curves.push_back({"none", kRed, Marker::Disc, {{0.0, 0.1, "not shown"}}});
    return plot;
}

TEST(Painter, FillsShapesAndNothingElse) {
    Drawing drawing{40.0, 20.0, {}};
    drawing.shapes.emplace_back(Disc{{10.0, 10.0}, 5.0, kRed, kRed, 0.0});
    drawing.shapes.emplace_back(
        Polygon{{{25.0, 5.0}, {35.0, 5.0}, {35.0, 15.0}, {25.0, 15.0}}, kRed, kRed, 0.0});
    const ByteImage image = paint(drawing, 2.0);
    EXPECT_EQ(image.width, 80);
    EXPECT_EQ(image.height, 40);
    EXPECT_TRUE(isRed(image, 20, 20));
    EXPECT_TRUE(isRed(image, 60, 12));
    EXPECT_FALSE(isRed(image, 42, 20));
    EXPECT_FALSE(isRed(image, 12, 12)) << "a corner of the disc's box";
}

TEST(Painter, DrawsDashesWithGaps) {
    Drawing drawing{64.0, 9.0, {}};
    drawing.shapes.emplace_back(Polyline{{{0.0, 4.5}, {64.0, 4.5}}, kRed, 3.0, 8.0});
    const ByteImage image = paint(drawing, 1.0);
    EXPECT_TRUE(isRed(image, 4, 4));
    EXPECT_FALSE(isRed(image, 12, 4));
    EXPECT_TRUE(isRed(image, 20, 4));
}

TEST(StrokeFont, KnowsEveryCharacterOfAscii) {
    for (char c = '!'; c <= '~'; ++c) {
        const auto strokes = textStrokes(std::string(1, c), 100.0);
        ASSERT_FALSE(strokes.empty()) << c;
        const double width = textWidth(std::string(1, c), 100.0);
        for (const auto& stroke : strokes) {
            EXPECT_GE(stroke.size(), 2U) << c;
            for (const glm::dvec2& p : stroke) {
                EXPECT_GE(p.x, 0.0) << c;
                EXPECT_LE(p.x, width + 1e-9) << c;
                EXPECT_GE(p.y, -95.0) << c;
                EXPECT_LE(p.y, 35.0) << c;
            }
        }
    }
}

TEST(SvgText, EscapesTextAndClosesItself) {
    const std::string svg = svgText(layOut(samplePlot()));
    EXPECT_NE(svg.find("Errors &amp; costs"), std::string::npos);
    EXPECT_NE(svg.find("&lt;first&gt;"), std::string::npos);
    EXPECT_EQ(svg.find("<first>"), std::string::npos);
    EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

TEST(PlotLayout, LeavesOutWhatALogarithmCannotShow) {
    const std::string svg = svgText(layOut(samplePlot()));
    EXPECT_NE(svg.find(">a</text>"), std::string::npos);
    EXPECT_EQ(svg.find("not shown"), std::string::npos);
    EXPECT_EQ(svg.find(">none</text>"), std::string::npos);
}

TEST(PlotLayout, KeepsEverythingInThePicture) {
    const Drawing drawing = layOut(samplePlot());
    for (const Shape& shape : drawing.shapes) {
        if (const auto* line = std::get_if<Polyline>(&shape)) {
            for (const glm::dvec2& p : line->points) {
                EXPECT_TRUE(p.x >= 0.0 && p.x <= drawing.width && p.y >= 0.0 &&
                            p.y <= drawing.height);
            }
        }
    }
}

TEST(PlotFiles, WritesBothKinds) {
    const std::filesystem::path stem = test::freshFolder() / "some.plot";
    EXPECT_EQ(writePlot(samplePlot(), stem), "");
    EXPECT_TRUE(std::filesystem::exists(stem.string() + ".svg"));
    const Result<ByteImage, ImageError> png = readPng(stem.string() + ".png");
    ASSERT_TRUE(png) << png.error().message;
    EXPECT_GT(png->width, 1000);
}

TEST(PlotFiles, SaysWhyItCannotWrite) {
    EXPECT_NE(writePlot(samplePlot(), test::freshFolder() / "absent" / "plot"), "");
}

} // namespace
} // namespace aolib::bench
