// The bakers that draw are good guests, too: the state between their calls and within their
// callbacks is the host's, and what GL refuses ends in a clean status.
#include <functional>
#include <memory>

#include <aolib/bake/AbstractBaker.h>

#include "RefusalTest.h"

namespace aolib {
namespace {

using bake::AbstractBaker;
using Baker = Result<std::unique_ptr<AbstractBaker>>;

class BakeStateGLTest : public RefusalTest {
protected:
    struct Method {
        const char* name;
        std::function<Baker(const ProcAddressLoader&)> create;
    };

    /// A floor that a smaller one hangs above.
    static bake::BakeScene scene() {
        bake::BakeScene scene;
        for (const float size : {2.0F, 1.0F}) {
            const float height = 2.0F - size;
            bake::Surface surface;
            surface.positions = {{-size, height, -size},
                                 {-size, height, size},
                                 {size, height, size},
                                 {size, height, -size}};
            surface.uvs = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
            surface.indices = {0, 1, 2, 0, 2, 3};
            surface.map = size == 2.0F ? 0 : -1;
            scene.surfaces.push_back(std::move(surface));
        }
        return scene;
    }
    static std::vector<Method> methods() {
        bake::ScatterOptions blended{.directions = 6, .rasterSize = 64};
        blended.sum = bake::PointSum::Blending;
        bake::ScatterOptions added = blended;
        added.sum = bake::PointSum::Processor;
        const bake::ShadowOptions shadow{.directions = 6, .depthSize = 64, .mapsPerPass = 2};
        const auto scatter = [](const bake::ScatterOptions& options) {
            return [options](const ProcAddressLoader& loader) {
                return bake::createScatterBaker(loader, scene(), options);
            };
        };
        return {{"scatter, blending", scatter(blended)},
                {"scatter, processor", scatter(added)},
                {"shadow", [shadow](const ProcAddressLoader& loader) {
                     return bake::createShadowBaker(loader, scene(), shadow);
                 }}};
    }
    static bake::MapOptions map() { return {.width = 16, .height = 16, .padding = 2}; }

    /// Everything that a baker of this method does. @return the first failure.
    static AoStatus bakeAll(const Method& method, const ProcAddressLoader& loader) {
        const Baker baker = method.create(loader);
        if (!baker) {
            return baker.status();
        }
        const auto maps = (*baker)->bakeMaps(map(), {});
        if (!maps) {
            return maps.status();
        }
        return (*baker)->bakeVertices({}, {}).status();
    }
};

TEST_P(BakeStateGLTest, BakingChangesNoState) {
    for (const Method& method : methods()) {
        for (unsigned seed = 0; seed < seeds(4); ++seed) {
            Dice dice(seed);
            poison->apply(dice, poison->randomView(dice), /*conditional=*/false);
            HostState::Snapshot expected = state->snapshot();
            const auto unchanged = [&](const char* when) {
                EXPECT_EQ(state->difference(expected, state->snapshot()), "")
                    << method.name << ", seed " << seed << ", " << when;
            };
            {
                Baker baker = method.create(loader);
                ASSERT_TRUE(baker.ok()) << baker.status().message();
                unchanged("made");
                int told = 0;
                const auto turnAll = [&](double /*fraction*/) {
                    unchanged("in its callback");
                    poison->apply(dice, poison->randomView(dice), /*conditional=*/false);
                    expected = state->snapshot();
                    return ++told < 100;
                };
                EXPECT_TRUE((*baker)->bakeMaps(map(), turnAll).ok());
                EXPECT_GT(told, 0);
                unchanged("maps");
                EXPECT_TRUE((*baker)->bakeVertices({}, turnAll).ok());
                unchanged("vertices");
                const auto cancel = [](double /*fraction*/) { return false; };
                EXPECT_EQ((*baker)->bakeMaps(map(), cancel).status().code(), StatusCode::Cancelled);
                unchanged("cancelled");
                EXPECT_EQ((*baker)->bakeMaps({.width = 0}, {}).status().code(),
                          StatusCode::InvalidOption);
                unchanged("refused");
            }
            unchanged("gone");
            poison->calm();
        }
    }
    (void)takeDriverMessages(); // about framebuffers that are incomplete on purpose
}

TEST_P(BakeStateGLTest, WhatGlRefusesEndsInAStatus) {
    for (const Method& method : methods()) {
        int refused = 0;
        for (int kind = 0; kind < kFaults; ++kind) {
            refused += refuseEach(
                method.name, static_cast<Fault>(kind),
                [&method](const ProcAddressLoader& with) { return bakeAll(method, with); });
            ASSERT_FALSE(HasFailure());
        }
        EXPECT_GT(refused, 15) << method.name;
    }
    poison->calm();
}

AOLIB_FOR_ALL_CONTEXTS(BakeStateGLTest);

} // namespace
} // namespace aolib
