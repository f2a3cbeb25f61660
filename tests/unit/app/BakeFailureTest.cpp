#include <chrono>
#include <csignal>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "BakeProgramTest.h"
#include "image/Pfm.h"

namespace aolib::test {
namespace {

/// What `aolib bake` does when it cannot, may not or need not go on.
class BakeFailureTest : public BakeProgramTest {
protected:
    /// Runs the program within a limit of the system's. Gives its exit code and what it said.
    std::pair<int, std::string> runLimited(int resource, rlim_t limit,
                                           std::vector<std::string> arguments) const {
        int ends[2] = {};
        EXPECT_EQ(pipe(ends), 0);
        const pid_t child = fork();
        if (child == 0) {
            const rlimit both{limit, limit};
            std::signal(SIGXFSZ, SIG_IGN);
            dup2(ends[1], STDOUT_FILENO);
            dup2(ends[1], STDERR_FILENO);
            close(ends[0]);
            close(ends[1]);
            std::vector<char*> words{const_cast<char*>(AOLIB_PROGRAM)};
            for (std::string& argument : arguments) {
                words.push_back(argument.data());
            }
            words.push_back(nullptr);
            if (chdir(path(".").c_str()) == 0 && setrlimit(resource, &both) == 0) {
                execv(AOLIB_PROGRAM, words.data());
            }
            _exit(127);
        }
        close(ends[1]);
        std::string said;
        char buffer[512];
        for (ssize_t n = read(ends[0], buffer, sizeof(buffer)); n > 0;
             n = read(ends[0], buffer, sizeof(buffer))) {
            said.append(buffer, static_cast<std::size_t>(n));
        }
        close(ends[0]);
        int status = 0;
        EXPECT_EQ(waitpid(child, &status, 0), child);
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, said};
    }
};

TEST_F(BakeFailureTest, WhatCannotBeUsedIsRefused) {
    expectRefused({"bake", "uv-box"}, {"--out", "needed"});
    expectRefused({"bake", "nothing", "-o", "a.glb"}, {"nothing", "uv-shapes"});
    expectRefused({"bake", "uv-box", "-o", "a.obj"}, {"--out", ".glb"});
    expectRefused({"bake", "uv-box", "-o", "a.glb", "--rays", "0"}, {"--rays"});
    expectRefused({"bake", "uv-box", "-o", "a.glb", "--ground", "deep"}, {"--ground"});
    expectRefused({"bake", "uv-box", "-o", "a.glb", "--target", "vertex", "--ao", "a.png"},
                  {"--target vertex"});
    expectRefused({"bake", "uv-box", "-o", "a.glb", "--target", "vertex", "--density", "0"},
                  {"density"});
    write("cut.glb", std::string("glTF\2\0\0\0\377\0\0\0", 12));
    expectRefused({"bake", "cut.glb", "-o", "a.glb"}, {"cut.glb"});
}

TEST_F(BakeFailureTest, CtrlCLeavesNothingBehind) {
    const pid_t child = fork();
    if (child == 0) {
        const int nowhere = open("/dev/null", O_WRONLY);
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
        if (chdir(path(".").c_str()) == 0) {
            execl(AOLIB_PROGRAM, AOLIB_PROGRAM, "bake", "uv-shapes", "-o", "out.glb", "--ao",
                  "ao.png", "--watch", "watch.png", "--size", "64", "--rays", "1000000",
                  static_cast<char*>(nullptr));
        }
        _exit(127);
    }
    ASSERT_GT(child, 0);
    // The bake takes many minutes; its first pass a moment.
    for (int ms = 0; names().empty() && ms < 60000; ++ms) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(names().front().substr(0, 9), "watch.png") << "it can be watched";
    kill(child, SIGINT);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status)) << "it was killed and had no chance to clean up";
    EXPECT_EQ(WEXITSTATUS(status), 1);
    EXPECT_EQ(names(), std::vector<std::string>());
}

#if !defined(__SANITIZE_ADDRESS__) // which maps more than any limit
TEST_F(BakeFailureTest, WithoutMemoryNothingIsWrittenAndASentenceSaysSo) {
    for (const char* method : {"rays", "scatter", "shadow"}) {
        const auto [code, said] = runLimited(
            RLIMIT_AS, rlim_t{1500} << 20U,
            {"bake", "uv-shapes", "-o", "out.glb", "--size", "16384", "--method", method});
        EXPECT_EQ(code, 1) << method;
        EXPECT_NE(said.find("no memory left"), std::string::npos) << said;
        EXPECT_EQ(names(), std::vector<std::string>()) << method;
    }
}
#endif

TEST_F(BakeFailureTest, AFullDiskLeavesNothingBehind) {
    const auto [code, said] = runLimited(
        RLIMIT_FSIZE, 2048,
        {"bake", "uv-shapes", "-o", "out.glb", "--ao", "ao.png", "--size", "128", "--rays", "2"});
    EXPECT_EQ(code, 1);
    EXPECT_NE(said.find("cannot be written"), std::string::npos) << said;
    EXPECT_EQ(names(), std::vector<std::string>());
}

TEST_F(BakeFailureTest, WhatIsEndedEarlyIsWrittenAndSaysHowFarItCame) {
    for (const char* method : {"rays", "scatter", "shadow"}) {
        const ProgramRun done =
            run({"bake",    "uv-shapes",    "-o",        "out.glb",   "--ao",
                 "ao.pfm",  "--watch",      "watch.pfm", "--seconds", "0.2",
                 "--size",  "32",           "--rays",    "1000000",   "--directions",
                 "1000000", "--depth-size", "64",        "--method",  method});
        EXPECT_EQ(done.exitCode, 0) << done.err;
        EXPECT_NE(done.out.find("ended after "), std::string::npos) << done.out;
        EXPECT_NE(done.out.find(" of 1000000 "), std::string::npos) << done.out;
        EXPECT_EQ(names(), (std::vector<std::string>{"ao.pfm", "out.glb", "watch.pfm"}));
        const auto map = readPfm(path("ao.pfm"));
        ASSERT_TRUE(map);
        EXPECT_GT(at(*map, 0.5F, 0.97F), 0.5F) << "the sphere's upper pole";
        EXPECT_LT(at(*map, 0.5F, 0.55F), 0.1F) << "its lower pole";
        EXPECT_EQ(bytesOf("ao.pfm"), bytesOf("watch.pfm"));
    }
    expectRefused({"bake", "uv-box", "-o", "a.glb", "--target", "vertex", "--seconds", "1"},
                  {"--seconds", "--target texture"});
    expectRefused({"bake", "uv-box", "-o", "a.glb", "--seconds", "0"}, {"--seconds", "above 0"});
    expectRefused({"bake", "uv-box", "-o", "a.glb", "--watch", "a.txt"}, {"--watch", ".png"});
}

} // namespace
} // namespace aolib::test
