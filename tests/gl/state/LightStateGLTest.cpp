// aolib::lighting is a good guest, too.
#include <aolib/lighting/EnvironmentLight.h>

#include "RefusalTest.h"

namespace aolib {
namespace {

class LightStateGLTest : public RefusalTest {
protected:
    static lighting::EnvironmentMap sky() {
        return {7, 3, std::vector<glm::vec3>(21, glm::vec3(0.5F))};
    }
    static lighting::EnvironmentLightOptions small() {
        lighting::EnvironmentLightOptions options;
        options.cones = {.columns = 8, .rows = 4, .apertures = 3};
        options.sectors = true;
        options.angles = true;
        options.anglesSize = 8;
        return options;
    }
};

TEST_P(LightStateGLTest, MakingAndDroppingALightChangesNoState) {
    lighting::EnvironmentLightOptions options = small();
    for (unsigned seed = 0; seed < seeds(12); ++seed) {
        Dice dice(seed);
        poison->apply(dice, poison->randomView(dice), /*conditional=*/false);
        const HostState::Snapshot before = state->snapshot();
        {
            const auto light = lighting::EnvironmentLight::create(loader, sky(), options);
            ASSERT_TRUE(light) << seed << ": " << light.status().message();
            EXPECT_EQ(state->difference(before, state->snapshot()), "") << seed;
        }
        EXPECT_EQ(state->difference(before, state->snapshot()), "") << seed;
        options.anglesSize = 0; // refused
        EXPECT_FALSE(lighting::EnvironmentLight::create(loader, sky(), options));
        options.anglesSize = 8;
        EXPECT_EQ(state->difference(before, state->snapshot()), "") << seed;
        poison->calm();
    }
    (void)takeDriverMessages();
}

TEST_P(LightStateGLTest, WhatGlRefusesEndsInAStatus) {
    for (int kind = 0; kind < kFaults; ++kind) {
        refuseEach("create", static_cast<Fault>(kind), [](const ProcAddressLoader& with) {
            return lighting::EnvironmentLight::create(with, sky(), small()).status();
        });
        ASSERT_FALSE(HasFailure());
    }
    poison->calm();
}

AOLIB_FOR_ALL_CONTEXTS(LightStateGLTest);

} // namespace
} // namespace aolib
