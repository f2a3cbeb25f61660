#include <gtest/gtest.h>

#include "viewer/FrameTimes.h"

namespace aolib::viewer {
namespace {

TEST(FrameTimesTest, KeepsTheLatestAndTheOrderOfPasses) {
    FrameTimes times;
    times.add({{"host", 100.0}, {"survey", 1.0}});
    for (std::size_t i = 0; i < FrameTimes::kKept; ++i) {
        times.add({{"host", 2.0}, {"blend", 3.0}});
    }
    EXPECT_EQ(times.frames().size(), FrameTimes::kKept);
    EXPECT_EQ(times.passes(), (std::vector<std::string>{"host", "survey", "blend"}));
    EXPECT_EQ(times.longest(), 5.0) << "the first frame has gone";
}

TEST(FrameTimesTest, MediansCountFramesWithoutThePass) {
    FrameTimes times;
    EXPECT_EQ(times.median("host"), 0.0);
    times.add({{"host", 1.0}, {"layers", 50.0}});
    times.add({{"host", 9.0}});
    times.add({{"host", 2.0}});
    EXPECT_EQ(times.median("host"), 2.0);
    EXPECT_EQ(times.median("layers"), 0.0);
}

} // namespace
} // namespace aolib::viewer
