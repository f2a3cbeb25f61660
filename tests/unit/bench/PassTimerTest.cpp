#include "bench/PassTimer.h"

#include <cstring>
#include <thread>

#include <gtest/gtest.h>

#include "gl/Functions.h"

namespace aolib::bench {
namespace {

using namespace std::chrono_literals;

int pushed = 0;
int popped = 0;

void APIENTRY countPush(GLenum /*source*/, GLuint /*id*/, GLsizei /*length*/,
                        const GLchar* /*message*/) {
    ++pushed;
}
void APIENTRY countPop() {
    ++popped;
}
void APIENTRY finish() {}

void* fakeLoader(const char* name) {
    if (std::strcmp(name, "glPushDebugGroup") == 0) {
        return reinterpret_cast<void*>(&countPush);
    }
    if (std::strcmp(name, "glPopDebugGroup") == 0) {
        return reinterpret_cast<void*>(&countPop);
    }
    return std::strcmp(name, "glFinish") == 0 ? reinterpret_cast<void*>(&finish) : nullptr;
}

double msOf(const std::vector<PassTime>& times, const std::string& pass) {
    for (const PassTime& time : times) {
        if (time.pass == pass) {
            return time.ms;
        }
    }
    return -1.0;
}

/// Sleeping takes at least as long as asked for, so lower bounds hold on any machine.
TEST(PassTimer, GivesTimeToTheInnermostPass) {
    pushed = popped = 0;
    PassTimer timer;
    const ProcAddressLoader loader = timer.wrap(fakeLoader);
    const auto push = reinterpret_cast<PFNGLPUSHDEBUGGROUPPROC>(loader("glPushDebugGroup"));
    const auto pop = reinterpret_cast<PFNGLPOPDEBUGGROUPPROC>(loader("glPopDebugGroup"));
    push(GL_DEBUG_SOURCE_APPLICATION, 0, -1, "aolib: before the start");
    pop();
    timer.start();
    push(GL_DEBUG_SOURCE_APPLICATION, 0, -1, "aolib: outer");
    std::this_thread::sleep_for(2ms);
    push(GL_DEBUG_SOURCE_APPLICATION, 0, 5, "inner, cut off");
    std::this_thread::sleep_for(20ms);
    pop();
    pop();
    const std::vector<PassTime> times = timer.stop();
    EXPECT_EQ(msOf(times, "before the start"), -1.0);
    EXPECT_GE(msOf(times, "outer"), 2.0);
    EXPECT_GE(msOf(times, "inner"), 20.0);
    EXPECT_GE(msOf(times, "other"), 0.0);
    EXPECT_EQ(pushed, 3) << "the driver must see the groups, too";
    EXPECT_EQ(popped, 3);
}

TEST(PassTimer, HandsOutEverythingElseUnchanged) {
    PassTimer timer;
    EXPECT_EQ(timer.wrap(fakeLoader)("glFinish"), reinterpret_cast<void*>(&finish));
}

TEST(MedianPasses, CountAbsentOnesAsNothing) {
    const std::vector<PassTime> medians =
        medianPasses({{{"a", 1.0}, {"b", 5.0}}, {{"a", 3.0}}, {{"a", 2.0}}});
    EXPECT_DOUBLE_EQ(msOf(medians, "a"), 2.0);
    EXPECT_DOUBLE_EQ(msOf(medians, "b"), 0.0);
}

} // namespace
} // namespace aolib::bench
