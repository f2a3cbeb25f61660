// aolib is a good guest: whatever state the host is in, every public call leaves it as it was, and
// no GL object outlives the instance that made it, by a ledger of what was made and deleted, and by
// asking GL for every name.
#include <set>

#include "AliveNames.h"
#include "FaultyLoader.h"
#include "Guest.h"
#include "HostTest.h"

namespace aolib {
namespace {

class StateGLTest : public HostTest {
protected:
    /// An error of the host's own that it has not asked for yet.
    GLenum plantError(Dice& dice) {
        const GLenum error = dice.pick<GLenum>(GL_NO_ERROR, {GL_INVALID_ENUM, GL_INVALID_VALUE});
        if (error == GL_INVALID_ENUM) {
            host->Enable(0xDEAD);
        } else if (error == GL_INVALID_VALUE) {
            host->LineWidth(-1.0F);
        }
        (void)takeDriverMessages();
        return error;
    }

    /// Makes random calls in random states and sees that they change nothing.
    void callInStates(Guest& guest, unsigned count);

    std::set<std::string> called_;

    /// The driver's messages, less those about a framebuffer of the host's that is incomplete.
    std::string complaints(const HostView& view) {
        const std::string text = takeDriverMessages();
        return view.target == HostTarget::Incomplete && text.find("error") == std::string::npos &&
                       text.find("FBO incomplete") != std::string::npos
                   ? std::string()
                   : text;
    }
};

/// Families of state, "GL_BLEND" of "GL_BLEND[3]", of which no value ever departed.
std::set<std::string> unmoved(const std::vector<std::string>& names,
                              const std::vector<bool>& moved) {
    std::set<std::string> still;
    std::set<std::string> moving;
    for (std::size_t i = 0; i < names.size(); ++i) {
        (moved[i] ? moving : still).insert(names[i].substr(0, names[i].find_first_of("[.")));
    }
    for (const std::string& name : moving) {
        still.erase(name);
    }
    return still;
}

TEST_P(StateGLTest, TheHarnessMovesEveryStateAndSeesIt) {
    const HostState::Snapshot calm = state->snapshot();
    EXPECT_EQ(state->difference(calm, state->snapshot()), "") << "looking changes nothing";
    const std::vector<std::string> names = state->names();
    ASSERT_EQ(names.size(), calm.size());
    EXPECT_GT(calm.size(), 2000U);
    std::vector<bool> moved(calm.size(), false);
    for (unsigned seed = 0; seed < 60; ++seed) {
        Dice dice(seed);
        poison->apply(dice, poison->randomView(dice), /*conditional=*/true);
        EXPECT_EQ(takeError(), static_cast<GLenum>(GL_NO_ERROR)) << "seed " << seed;
        const HostState::Snapshot poisoned = state->snapshot();
        ASSERT_EQ(state->difference(poisoned, state->snapshot()), "") << "seed " << seed;
        for (std::size_t i = 0; i < calm.size(); ++i) {
            moved[i] = moved[i] || poisoned[i] != calm[i];
        }
        poison->calm();
        ASSERT_EQ(state->difference(calm, state->snapshot()), "") << "seed " << seed;
    }
    (void)takeDriverMessages(); // about the framebuffer that is incomplete on purpose
    // What only watches: the tests' log owns the callback, and objects keep their parameters.
    std::set<std::string> watched{"GL_DEBUG_CALLBACK_FUNCTION",
                                  "GL_DEBUG_CALLBACK_USER_PARAM",
                                  "GL_DEBUG_OUTPUT_SYNCHRONOUS",
                                  "sampler",
                                  "uniform",
                                  "texture",
                                  "kRenderMode",
                                  "kCurrentRasterColor",
                                  "kCurrentRasterPosition"};
    std::string rest;
    for (const std::string& name : unmoved(names, moved)) {
        rest += watched.count(name) == 0 ? name + "\n" : std::string();
    }
    EXPECT_EQ(rest, "") << "never moved by the poison";
}

void StateGLTest::callInStates(Guest& guest, unsigned count) {
    for (unsigned seed = 0; seed < count && !HasFailure(); ++seed) {
        Dice dice(seed);
        const HostView view = poison->randomView(dice);
        poison->apply(dice, view, /*conditional=*/true);
        ASSERT_EQ(takeError(), static_cast<GLenum>(GL_NO_ERROR)) << "the harness, seed " << seed;
        const Guest::Situation situation{frameStatus(view), applyStatus(view),
                                         host->has.compatibility};
        for (int i = 0; i < 3; ++i) {
            const GLenum planted = plantError(dice);
            const HostState::Snapshot before = state->snapshot();
            const Guest::Outcome outcome = guest.call(dice, situation);
            const std::string difference = state->difference(before, state->snapshot());
            const std::string where = outcome.call + ", seed " + std::to_string(seed);
            EXPECT_EQ(difference, "") << where;
            EXPECT_EQ(outcome.fault, "") << where;
            EXPECT_EQ(takeError(), planted) << where << ": the host's error flag";
            EXPECT_EQ(takeError(), static_cast<GLenum>(GL_NO_ERROR)) << where;
            EXPECT_EQ(complaints(view), "") << where;
            called_.insert(outcome.call);
        }
    }
    poison->release();
    EXPECT_EQ(takeError(), static_cast<GLenum>(GL_NO_ERROR)) << "what the host runs still ran";
}

TEST_P(StateGLTest, EveryCallLeavesEveryStateAsItWasAndNothingBehind) {
    FaultyLoader ledger(loader);
    const auto before = aliveNames(*host);
    {
        Guest guest(ledger.loader(), gl);
        const unsigned count = seeds(300);
        callInStates(guest, count);
        if (count >= 300) {
            EXPECT_EQ(called_.size(), Guest::kinds()) << "some call was never drawn";
            EXPECT_GT(guest.pixelsAtRest(), 0U) << "no view was at rest";
        }
        EXPECT_NE(ledger.alive(), "") << "the ledger must see something";
        EXPECT_NE(aliveNames(*host), before);
    }
    EXPECT_EQ(ledger.alive(), "");
    poison->calm();
    EXPECT_EQ(aliveNames(*host), before);
    (void)takeDriverMessages(); // about framebuffers that are incomplete on purpose
}

TEST_P(StateGLTest, SoDoesOneThatKnowsNothingBeyondGl33) {
    const ProcAddressLoader old = HostGl::withoutNewer(loader);
    setUpHost(/*newest=*/false);
    Guest guest(old, gl);
    callInStates(guest, seeds(60));
}

AOLIB_FOR_ALL_CONTEXTS(StateGLTest);

} // namespace
} // namespace aolib
