#include <gtest/gtest.h>

#include <imgui.h>

#include <aolib/OptionFields.h>

#include "viewer/OptionTexts.h"
#include "viewer/OptionsPanel.h"

namespace aolib::viewer {
namespace {

/// The panel in ImGui without a window: frames of 400 by 1000 pixels, a mouse that is told where to
/// be.
class OptionsPanelTest : public testing::Test {
protected:
    void SetUp() override {
        ImGui::CreateContext();
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {400.0F, 1000.0F};
        unsigned char* pixels = nullptr;
        int width = 0;
        int height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    }
    void TearDown() override { ImGui::DestroyContext(); }

    bool frame() {
        ImGui::GetIO().DeltaTime = 1.0F / 60.0F;
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0.0F, 0.0F});
        ImGui::SetNextWindowSize({400.0F, 1000.0F});
        ImGui::Begin("panel", nullptr, ImGuiWindowFlags_NoDecoration);
        const bool changed = panel.draw(options, defaults, 10.0F);
        ImGui::End();
        ImGui::Render();
        return changed;
    }

    /// A click at a share of an option's width. Returns whether any frame changed an option.
    bool click(const std::string& name, float share, int button = 0) {
        frame();
        const glm::vec4 place = panel.places().find(name)->second;
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = {place.x + share * place.z, place.y + 0.5F * place.w};
        bool changed = frame();
        for (const bool down : {true, true, false, false}) {
            io.MouseDown[button] = down;
            changed = frame() || changed;
        }
        return changed;
    }

    Options defaults;
    Options options;
    OptionsPanel panel;
};

TEST_F(OptionsPanelTest, HasAWidgetForEveryOption) {
    EXPECT_FALSE(frame());
    std::size_t count = 0;
    visitOptions(options, [&](std::string_view name, auto&, const auto&...) {
        EXPECT_TRUE(panel.places().contains(name)) << name;
        ++count;
    });
    EXPECT_EQ(panel.places().size(), count);
    EXPECT_EQ(optionTexts(options), optionTexts(defaults)) << "drawing changes nothing";
}

TEST_F(OptionsPanelTest, SwitchesSwitch) {
    EXPECT_TRUE(click("outlines", 0.5F));
    EXPECT_TRUE(options.cubeMaps.outlines);
    EXPECT_TRUE(click("outlines", 0.5F));
    EXPECT_FALSE(options.cubeMaps.outlines);
}

TEST_F(OptionsPanelTest, SlidersReachBothEndsOfTheRange) {
    EXPECT_TRUE(click("contrast", 0.01F));
    EXPECT_EQ(options.contrast, 0.0F);
    EXPECT_TRUE(click("contrast", 0.99F));
    EXPECT_EQ(options.contrast, 1.0F);
    EXPECT_TRUE(click("texel-rays", 0.01F));
    EXPECT_EQ(options.rayTraced.rays, 4);
    EXPECT_TRUE(click("texel-rays", 0.99F));
    EXPECT_EQ(options.rayTraced.rays, 65536);
    EXPECT_TRUE(click("radius", 0.99F));
    EXPECT_EQ(options.radius, 10.0F) << "as far as the scene is large";
}

TEST_F(OptionsPanelTest, OddOptionsStayOdd) {
    for (const float share : {0.1F, 0.2F, 0.3F, 0.4F, 0.6F, 0.8F}) {
        click("blur-size", share);
        EXPECT_EQ(options.blur.size % 2, 1) << share;
    }
}

TEST_F(OptionsPanelTest, ARightClickPutsADefaultBack) {
    options.contrast = 0.25F;
    options.radius = 3.0F;
    EXPECT_TRUE(click("contrast", 0.5F, 1));
    EXPECT_EQ(options.contrast, defaults.contrast);
    EXPECT_EQ(options.radius, 3.0F) << "and no other";
}

TEST_F(OptionsPanelTest, FaintIsWhatDoesNotCountNow) {
    EXPECT_TRUE(appliesTo("ray-traced: rays per texel", Estimator::RayTraced));
    EXPECT_FALSE(appliesTo("ray-traced: rays per texel", Estimator::HorizonSplit));
    EXPECT_TRUE(appliesTo("ray-traced, and layered-intervals with a tracer: trace", //
                          Estimator::LayeredIntervals));
    EXPECT_TRUE(appliesTo("cube map: texels per face edge", Estimator::RayTraced));
    EXPECT_TRUE(appliesTo("strength of the darkening", Estimator::HorizonSplit));
}

} // namespace
} // namespace aolib::viewer
