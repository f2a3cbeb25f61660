#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "WindowTest.h"
#ifdef AOLIB_TEST_X11
#include "FileDrop.h"
#endif

namespace aolib::test {

namespace {

using nlohmann::json;

class WindowGLTest : public WindowTest {};

glm::vec3 positionOf(const json& list) {
    return {list[0].get<float>(), list[1].get<float>(), list[2].get<float>()};
}

double eyeDistance(const json& s) {
    return static_cast<double>(glm::distance(positionOf(s["eye"]), positionOf(s["target"])));
}

TEST_F(WindowGLTest, MouseAndKeysMoveTheCamera) {
    start(kSmall);
    waitForRest();
    const json before = state();
    drag(100, 500, 180, 520);
    waitFor("a turned camera", [&](const json& s) { return s["eye"] != before["eye"]; });
    EXPECT_EQ(state()["target"], before["target"]);
    EXPECT_NEAR(eyeDistance(state()), eyeDistance(before), 1e-3);

    const json turned = state();
    input({"click", "4"}); // a notch of the wheel, away from the user
    waitFor("a nearer camera",
            [&](const json& s) { return eyeDistance(s) < 0.95 * eyeDistance(turned); });
    key("r");
    waitFor("the first camera", [&](const json& s) { return s["eye"] == before["eye"]; });

    key("w");
    waitForRest();
    EXPECT_EQ(state()["eye"], before["eye"]) << "W is for those who walk";
    key("f");
    waitFor("walking", [](const json& s) { return s["mode"] == "walk"; });
    holdKey("w");
    waitFor("steps", [&](const json& s) { return s["eye"] != before["eye"]; });
    releaseKey("w");
    waitForRest();
    quit();
}

TEST_F(WindowGLTest, AtRestItDrawsNothing) {
    start(kSmall);
    waitForRest();
    key("F12"); // its message goes by itself, in a frame of its own
    waitFor("a message", [](const json& s) { return s["message"] != ""; });
    waitForRest();
    const int frames = state()["frames"];
    input({"sleep", "0.6"});
    EXPECT_LE(state()["frames"].get<int>(), frames + 1);
    moveMouse(50, 60);
    waitFor("frames again", [&](const json& s) { return s["frames"] > frames + 1; });
    quit();
}

TEST_F(WindowGLTest, OptionsChangeByKeysAndByTheMouse) {
    start(kSmall);
    key("v");
    waitFor("a debug view", [](const json& s) { return s["options"]["debug-view"] == "ao"; });
    key("b");
    waitFor("the other backbone",
            [](const json& s) { return s["options"]["backbone"] == "screenspace"; });
    key("o");
    waitFor("no occlusion", [](const json& s) { return !s["occlusion"].get<bool>(); });
    key("F1");
    waitFor("help", [](const json& s) { return s["help"].get<bool>(); });
    key("F1");
    waitFor("no help", [](const json& s) { return !s["help"].get<bool>(); });

    const json place = state()["widgets"]["refine-static-views"];
    click(place[0].get<double>() + 8.0, place[1].get<double>() + 8.0);
    waitFor("no repair",
            [](const json& s) { return s["options"]["refine-static-views"] == "off"; });
    const json slider = state()["widgets"]["contrast"];
    click(slider[0].get<double>() + 0.5 * slider[2].get<double>(), slider[1].get<double>() + 8.0);
    waitFor("half the contrast", [](const json& s) {
        return std::abs(std::stod(s["options"]["contrast"].get<std::string>()) - 0.5) < 0.1;
    });

    const int width = state()["picture"][0];
    key("Tab");
    waitFor("no panel", [&](const json& s) { return s["picture"][0] > width && !s["panel"]; });
    quit();
}

TEST_F(WindowGLTest, CubeMapsArePlacedChosenAndRemoved) {
    start(with(kSmall, {"--marks"}));
    waitForRest();
    ASSERT_EQ(state()["cube_maps"].size(), 1U);
    drag(100, 500, 160, 560);
    key("m");
    waitFor("two cube maps", [](const json& s) { return s["cube_maps"].size() == 2; });
    EXPECT_FALSE(state()["chosen"].is_null());
    key("Delete");
    waitFor("one cube map", [](const json& s) { return s["cube_maps"].size() == 1; });
    EXPECT_TRUE(state()["chosen"].is_null());
    quit();
}

TEST_F(WindowGLTest, MarksAreDraggedInTheViewPlaneAndAlongTheRay) {
    start(with(kSmall, {"--marks", "--no-place"}));
    key("m"); // at the camera, which then steps back
    waitFor("a cube map", [](const json& s) { return s["cube_maps"].size() == 1; });
    moveMouse(100, 500);
    input({"click", "--repeat", "5", "5"});
    waitFor("its mark", [](const json& s) { return !s["marks"][0].is_null(); });
    waitForRest();
    const auto markAt = [](const json& s) {
        return glm::vec2(s["marks"][0][0].get<float>(), s["marks"][0][1].get<float>());
    };
    const auto depth = [](const json& s) {
        const glm::vec3 eye = positionOf(s["eye"]);
        return glm::dot(positionOf(s["cube_maps"][0]) - eye,
                        glm::normalize(positionOf(s["target"]) - eye));
    };
    const auto hasMoved = [&](const json& before) {
        return [&, before](const json& s) { return s["cube_maps"] != before["cube_maps"]; };
    };
    const json first = state();
    ASSERT_EQ(first["cube_maps"].size(), 1U);
    const glm::vec2 begin = markAt(first);
    drag(begin.x, begin.y, begin.x + 40, begin.y - 20);
    waitFor("a cube map elsewhere", hasMoved(first));
    waitForRest();
    const json second = state();
    EXPECT_NEAR(glm::distance(markAt(second), begin + glm::vec2(40, -20)), 0.0F, 1.5F);
    EXPECT_NEAR(depth(second), depth(first), 1e-3F * depth(first));
    EXPECT_EQ(second["eye"], first["eye"]) << "the camera stays";
    EXPECT_FALSE(second["chosen"].is_null());

    const glm::vec2 middle = markAt(second);
    holdKey("shift");
    drag(middle.x, middle.y, middle.x, middle.y + 30);
    releaseKey("shift");
    waitFor("a nearer cube map", hasMoved(second));
    waitForRest();
    const json third = state();
    EXPECT_NEAR(glm::distance(markAt(third), middle), 0.0F, 1.5F);
    EXPECT_LT(depth(third), 0.95F * depth(second));

    // Faster than frames: the button goes down and the mouse on at once.
    const glm::vec2 last = markAt(third);
    moveMouse(last.x, last.y);
    input({"mousedown", "1", "mousemove", "--window", window(), std::to_string(int(last.x) - 30),
           std::to_string(int(last.y) + 10)});
    waitFor("a dragged mark", [&](const json& s) { return glm::distance(markAt(s), last) > 20; });
    EXPECT_EQ(state()["cube_maps"], third["cube_maps"]);
    key("Escape");
    waitFor("the mark back", [&](const json& s) { return glm::distance(markAt(s), last) < 1; });
    moveMouse(last.x - 40, last.y + 20);
    input({"mouseup", "1"});
    waitForRest();
    EXPECT_EQ(state()["cube_maps"], third["cube_maps"]);
    EXPECT_EQ(state()["eye"], first["eye"]);
    quit();
}

TEST_F(WindowGLTest, TheTruthComesIsMeasuredAndForgottenWhenTheCameraMoves) {
    start(with(kSmall, {"--truth-rays", "16", "--compare", "truth"}));
    waitFor("a truth", [](const json& s) { return s["truth"]["rays"] == 16; });
    waitForRest();
    EXPECT_EQ(state()["truth"]["progress"], 1.0);
    EXPECT_GT(state()["truth"]["rmse"], 0.0);
    EXPECT_LT(state()["truth"]["rmse"], 0.3);

    const json before = state();
    drag(160, 300, 240, 310); // the line
    waitFor("a moved line",
            [](const json& s) { return std::abs(s["split"].get<double>() - 0.75) < 0.02; });
    EXPECT_EQ(state()["eye"], before["eye"]);
    EXPECT_EQ(state()["truth"]["rays"], 16);

    drag(60, 300, 90, 300);
    waitFor("another truth", [&](const json& s) {
        return s["eye"] != before["eye"] && s["truth"]["rays"] == 16 &&
               s["truth"]["noise"] != before["truth"]["noise"];
    });
    key("c");
    waitFor("the difference", [](const json& s) { return s["compared"] == "difference"; });
    waitForRest();
    quit();
}

TEST_F(WindowGLTest, FilesAreOpenedAndBadOnesLeaveTheOldScene) {
    write("broken.glb", "not a model");
    write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    start(kSmall);
    openByPath("broken.glb");
    waitFor("the reason", [](const json& s) {
        return s["message"].get<std::string>().find("broken.glb") != std::string::npos;
    });
    EXPECT_EQ(state()["scene"], "cornell");
    EXPECT_EQ(state()["mode"], "orbit") << "letters that are typed are no commands";
    openByPath("triangle.obj");
    waitFor("the triangle", [](const json& s) { return s["triangles"] == 1; });
#ifdef AOLIB_TEST_X11
    write("dropped.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
    EXPECT_EQ(dropFile(display().name(), window(), path("dropped.obj").string()), "");
    waitFor("what was dropped", [](const json& s) { return s["triangles"] == 2; });
#endif
    waitForRest();
    quit();
}

TEST_F(WindowGLTest, EnvironmentsAreDroppedAndBadOnesLeaveTheOldOne) {
    // One pixel of radiance 1, 1, 1.
    write("white.hdr", std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n") +
                           std::string("\x80\x80\x80\x81\x80\x80\x80\x81"));
    write("broken.hdr", "not a picture");
    start(with(kSmall, {"--lit-rays", "4", "--lit-edge", "20"}));
    EXPECT_EQ(state()["light"]["vertices"], 0) << "nobody has asked for it";
    openByPath("white.hdr");
    waitFor("baked vertices", [](const json& s) { return s["light"]["vertices"] > 0; });
    EXPECT_EQ(state()["compared"], "environment");
    const std::string white = state()["environment"];
    EXPECT_NE(white.find("white.hdr"), std::string::npos);
    openByPath("broken.hdr");
    waitFor("the reason", [](const json& s) {
        return s["message"].get<std::string>().find("broken.hdr") != std::string::npos;
    });
    EXPECT_EQ(state()["environment"], white);
    EXPECT_EQ(state()["scene"], "cornell");
    waitForRest();
    quit();
}

TEST_F(WindowGLTest, WithoutADisplayItSaysSo) {
    const ProgramRun refused = run({"view", "cornell"}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}});
    EXPECT_EQ(refused.exitCode, 3);
    EXPECT_NE(refused.err.find("GLFW"), std::string::npos) << refused.err;
}

TEST_F(WindowGLTest, BadArgumentsOpenNoWindow) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"view", "nowhere.glb"},
          {"view", "cornell", "--screenshot", "picture.jpg"},
          {"view", "cornell", "--folder", "nowhere"},
          {"view", "cornell", "--compare", "nothing"},
          {"view", "cornell", "--environment", "nowhere"},
          {"view", "cornell", "--split", "2"}}) {
        const ProgramRun refused = run(arguments, environment());
        EXPECT_EQ(refused.exitCode, 2) << arguments.back() << refused.err;
        EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    }
    EXPECT_TRUE(names().empty());
}

} // namespace

} // namespace aolib::test
