// No GL object outlives an instance that could not be made; StateGLTest has those that lived.
#include "AliveNames.h"
#include "FaultyLoader.h"
#include "Guest.h"
#include "HostTest.h"

namespace aolib {
namespace {

class LeakGLTest : public HostTest {};

TEST_P(LeakGLTest, NothingIsLeftOfWhatCouldNotBeMade) {
    FaultyLoader faulty(loader);
    const auto before = aliveNames(*host);
    for (int kind = 0; kind < kFaults; ++kind) {
        for (const int n : {1, 2, 5}) {
            faulty.failAt(static_cast<Fault>(kind), n);
            (void)AmbientOcclusion::create(faulty.loader(), smallOptions());
        }
    }
    EXPECT_EQ(aliveNames(*host), before);
}

AOLIB_FOR_ALL_CONTEXTS(LeakGLTest);

} // namespace
} // namespace aolib
