// No GL object outlives the instance that made it: by a ledger of what was made and deleted, and by
// asking GL for every name.
#include <set>
#include <utility>

#include "FaultyLoader.h"
#include "Guest.h"
#include "HostTest.h"

namespace aolib {
namespace {

/// The names of each kind that are alive, by the host's own functions.
std::set<std::pair<char, GLuint>> aliveNames(const HostGl& gl) {
    constexpr GLuint kNames = 4096; // more than a test ever has
    std::set<std::pair<char, GLuint>> alive;
    for (GLuint name = 1; name < kNames; ++name) {
        const auto note = [&](char kind, GLboolean is) {
            if (is == GL_TRUE) {
                alive.insert({kind, name});
            }
        };
        note('t', gl.IsTexture(name));
        note('b', gl.IsBuffer(name));
        note('f', gl.IsFramebuffer(name));
        note('r', gl.IsRenderbuffer(name));
        note('v', gl.IsVertexArray(name));
        note('q', gl.IsQuery(name));
        note('s', gl.IsSampler(name));
        note('p', gl.IsProgram(name));
        note('h', gl.IsShader(name));
    }
    return alive;
}

class LeakGLTest : public HostTest {};

TEST_P(LeakGLTest, NothingIsLeftAfterALongLife) {
    FaultyLoader ledger(loader);
    const auto before = aliveNames(*host);
    {
        Guest guest(ledger.loader(), gl);
        for (unsigned seed = 0; seed < seeds(60); ++seed) {
            Dice dice(seed);
            const HostView view = poison->randomView(dice);
            poison->apply(dice, view);
            for (int i = 0; i < 3; ++i) {
                const auto outcome = guest.call(
                    dice, {frameStatus(view), applyStatus(view), host->has.compatibility});
                EXPECT_EQ(outcome.fault, "") << outcome.call << ", seed " << seed;
            }
        }
        EXPECT_NE(ledger.alive(), "") << "the ledger must see something";
        EXPECT_NE(aliveNames(*host), before);
    }
    EXPECT_EQ(ledger.alive(), "");
    poison->calm();
    EXPECT_EQ(aliveNames(*host), before);
    (void)takeDriverMessages(); // about framebuffers that are incomplete on purpose
}

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
