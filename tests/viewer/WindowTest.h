#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/types.h>

#include "Display.h"
#include "Program.h"

namespace aolib::test {

/// A test of the window: "aolib view" as a process on a display of the suite's own, with keys and
/// a mouse that X believes to be real. What it did is read from the file that --state keeps.
class WindowTest : public ProgramTest {
protected:
    static void SetUpTestSuite();
    static void TearDownTestSuite();
    void SetUp() override;
    void TearDown() override;

    /// Starts the viewer in the test's folder and waits for its first frames.
    void start(std::vector<std::string> arguments);
    /// Waits for its end. Returns the exit code.
    int finish();
    /// Ends it as a user does, and expects it to have had no trouble.
    void quit();

    /// A scene of 34 triangles and as little work as there can be.
    static const std::vector<std::string> kSmall;
    static std::vector<std::string> with(std::vector<std::string> arguments,
                                         const std::vector<std::string>& more);

    /// The state as it is now.
    nlohmann::json state() const;
    /// Waits until a state is as it should be; throws, and so ends the test, if it never is.
    void waitFor(const std::string& what,
                 const std::function<bool(const nlohmann::json&)>& condition);
    /// Moves the mouse by a pixel, and waits until the window shows what there is to show.
    void waitForRest();

    void key(const std::string& name) { input({"key", name}); }
    /// The same for panels, which look at each frame which keys are down: down for a frame.
    void pressKey(const std::string& name);
    void holdKey(const std::string& name) { input({"keydown", name}); }
    void releaseKey(const std::string& name) { input({"keyup", name}); }
    void moveMouse(double x, double y);
    void click(double x, double y);
    /// Presses the left button at one place, moves in steps to another, and releases it.
    void drag(double x, double y, double toX, double toY);
    void type(const std::string& text) { input({"type", "--delay", "20", text}); }
    /// Types the path of one of the test's files into the viewer's field.
    void openByPath(const std::string& name);
    /// Any arguments of xdotool.
    void input(const std::vector<std::string>& words);

    std::map<std::string, std::string> environment() const;
    const std::string& window() const { return window_; } ///< X's number
    static const Display& display() { return *display_; }

private:
    /// Waits a frame or two, so that what was done is seen before the next thing is.
    void waitForFrames(int count);
    std::string runTool(const std::vector<std::string>& words) const;

    static std::unique_ptr<Display> display_;
    static std::string problem_;
    pid_t viewer_ = 0;
    int nudge_ = 1;
    std::string window_;
};

} // namespace aolib::test
