#include <gtest/gtest.h>

#include "viewer/OptionTexts.h"
#include "viewer/SceneInstance.h"

namespace aolib::viewer {
namespace {

TEST(OptionTextsTest, EveryOptionHasOne) {
    Options options;
    std::size_t count = 0;
    visitOptions(options, [&](std::string_view name, auto&, const auto&...) {
        EXPECT_EQ(optionTexts(options).at(count++).name, name);
    });
    EXPECT_EQ(optionTexts(options).size(), count);
}

TEST(OptionTextsTest, AnyChangeShows) {
    const Options before;
    Options after;
    after.cubeMaps.faceSize = 256;
    EXPECT_NE(optionTexts(before), optionTexts(after));
    EXPECT_EQ(optionFlags(after, before), "--face-size 256");
    after.blur.enabled = false;
    after.cubeMaps.outlines = true;
    after.falloff = Falloff::Exp;
    EXPECT_EQ(optionFlags(after, before), "--falloff exp --face-size 256 --outlines --no-blur");
    EXPECT_EQ(optionFlags(before, before), "");
}

TEST(OptionTextsTest, NumbersAreExact) {
    Options options;
    options.radius = 0.1F + 0.2F;
    for (const OptionText& text : optionTexts(options)) {
        if (text.name == "radius") {
            EXPECT_EQ(std::stof(text.value), options.radius);
        }
    }
}

TEST(OptionTextsTest, ScreenSpaceKnowsNoRays) {
    Options options;
    options.estimator = Estimator::RayTraced;
    options.contrast = 0.5F;
    EXPECT_EQ(inScreenSpace(options).backbone, Backbone::ScreenSpace);
    EXPECT_EQ(inScreenSpace(options).estimator, Estimator::LayeredIntervals);
    EXPECT_EQ(inScreenSpace(options).contrast, 0.5F);
    options.estimator = Estimator::HorizonSplit;
    EXPECT_EQ(inScreenSpace(options).estimator, Estimator::HorizonSplit);
}

} // namespace
} // namespace aolib::viewer
