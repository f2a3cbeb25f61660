#include "WindowTest.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace aolib::test {

namespace {

using Clock = std::chrono::steady_clock;
using nlohmann::json;

/// Far beyond what is needed: only a window that hangs reaches it.
constexpr std::chrono::seconds kPatience{60};
constexpr std::chrono::milliseconds kLook{20};
constexpr int kFirstFrames = 4;
/// A window at rest that long has seen everything that was done.
constexpr std::chrono::seconds kRest{2};

std::string shellWord(const std::string& word) {
    return "'" + word + "'";
}

} // namespace

std::unique_ptr<Display> WindowTest::display_;
std::string WindowTest::problem_;
const std::vector<std::string> WindowTest::kSmall{
    "cornell",     "--width", "320",         "--height",      "1100",
    "--face-size", "16",      "--estimator", "horizon-split", "--directions",
    "2",           "--steps", "2",           "--no-blur",     "--gl-debug"};

void WindowTest::SetUpTestSuite() {
    if (std::system("command -v xdotool >/dev/null 2>&1") != 0) {
        problem_ = "there is no xdotool; scripts/setup installs it";
        return;
    }
    display_ = Display::start(problem_);
}

void WindowTest::TearDownTestSuite() {
    display_.reset();
}

void WindowTest::SetUp() {
    ProgramTest::SetUp();
    if (!display_) {
        GTEST_SKIP() << "NOT TESTED: " << problem_;
    }
}

void WindowTest::TearDown() {
    if (viewer_ > 0) {
        kill(viewer_, SIGKILL);
        waitpid(viewer_, nullptr, 0);
        viewer_ = 0;
    }
    ProgramTest::TearDown();
}

std::map<std::string, std::string> WindowTest::environment() const {
    return {{"DISPLAY", display_->name()}, {"LIBGL_ALWAYS_SOFTWARE", "1"}};
}

void WindowTest::start(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {AOLIB_PROGRAM, "view"});
    arguments.insert(arguments.end(), {"--state", "state.json"});
    viewer_ = fork();
    if (viewer_ == 0) {
        for (const auto& [name, value] : environment()) {
            setenv(name.c_str(), value.c_str(), 1);
        }
        unsetenv("WAYLAND_DISPLAY");
        const int log = open(path("log").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        dup2(log, STDOUT_FILENO);
        dup2(log, STDERR_FILENO);
        std::vector<char*> argv;
        for (std::string& argument : arguments) {
            argv.push_back(argument.data());
        }
        argv.push_back(nullptr);
        if (chdir(path("").c_str()) == 0) {
            execv(argv[0], argv.data());
        }
        _exit(127);
    }
    waitFor("its first frames", [](const json& s) { return s["frames"] >= kFirstFrames; });
    window_ = runTool({"search", "--onlyvisible", "--name", "aolib view"});
    if (window_.empty()) {
        throw std::runtime_error("X shows no window");
    }
    input({"windowfocus", "--sync", window_});
}

int WindowTest::finish() {
    int status = 0;
    waitpid(viewer_, &status, 0);
    viewer_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void WindowTest::quit() {
    key("ctrl+q");
    EXPECT_EQ(finish(), 0) << bytesOf("log");
}

std::vector<std::string> WindowTest::with(std::vector<std::string> arguments,
                                          const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

json WindowTest::state() const {
    std::ifstream stream(path("state.json"));
    return stream ? json::parse(stream, nullptr, /*allow_exceptions=*/false) : json();
}

void WindowTest::waitFor(const std::string& what,
                         const std::function<bool(const json&)>& condition) {
    const Clock::time_point end = Clock::now() + kPatience;
    while (Clock::now() < end) {
        const json now = state();
        if (now.is_object() && condition(now)) {
            return;
        }
        if (waitpid(viewer_, nullptr, WNOHANG) != 0) {
            viewer_ = 0;
            throw std::runtime_error("the viewer ended while waiting for " + what + ":\n" +
                                     bytesOf("log"));
        }
        std::this_thread::sleep_for(kLook);
    }
    throw std::runtime_error("never came: " + what + "\n" + state().dump(1));
}

void WindowTest::waitForRest() {
    nudge_ = -nudge_; // a window at rest draws nothing that would tell
    input({"mousemove_relative", "--", std::to_string(nudge_), "0"});
    waitForFrames(1);
    waitFor("rest", [](const json& s) { return s["settled"].get<bool>(); });
}

void WindowTest::waitForFrames(int count) {
    const int before = state()["frames"];
    const Clock::time_point rested =
        Clock::now() + kRest; // it may have been quicker than this test
    waitFor("a frame", [&](const json& s) {
        return s["frames"] >= before + count || (s["settled"].get<bool>() && Clock::now() > rested);
    });
}

std::string WindowTest::runTool(const std::vector<std::string>& words) const {
    std::string command = "DISPLAY=" + display_->name() + " xdotool";
    for (const std::string& word : words) {
        command += " " + shellWord(word);
    }
    FILE* pipe = popen(command.c_str(), "r");
    std::string output;
    for (int letter = 0; pipe != nullptr && (letter = std::fgetc(pipe)) != EOF;) {
        output += static_cast<char>(letter);
    }
    EXPECT_TRUE(pipe != nullptr && pclose(pipe) == 0) << command;
    return output.substr(0, output.find('\n'));
}

void WindowTest::openByPath(const std::string& name) {
    const json place = state()["widgets"]["path"];
    click(place[0].get<double>() + 20.0, place[1].get<double>() + 8.0);
    pressKey("ctrl+a");
    type(path(name).string());
    pressKey("Return");
}

void WindowTest::input(const std::vector<std::string>& words) {
    runTool(words);
}

void WindowTest::pressKey(const std::string& name) {
    input({"keydown", name});
    waitForFrames(1);
    input({"keyup", name});
    waitForFrames(1);
}

void WindowTest::moveMouse(double x, double y) {
    input({"mousemove", "--window", window_, std::to_string(static_cast<int>(x)),
           std::to_string(static_cast<int>(y))});
    waitForFrames(1);
}

void WindowTest::click(double x, double y) {
    moveMouse(x, y);
    input({"mousedown", "1"});
    waitForFrames(1);
    input({"mouseup", "1"});
    waitForFrames(1);
}

void WindowTest::drag(double x, double y, double toX, double toY) {
    moveMouse(x, y);
    input({"mousedown", "1"});
    waitForFrames(1);
    moveMouse(0.5 * (x + toX), 0.5 * (y + toY));
    moveMouse(toX, toY);
    input({"mouseup", "1"});
    waitForFrames(1);
}

} // namespace aolib::test
