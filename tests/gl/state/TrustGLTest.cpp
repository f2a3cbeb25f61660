// What a host says it restores by itself is neither asked for nor restored; all the rest still is.
// And how little is asked for.
#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "Guest.h"
#include "HostTest.h"
#include "QueryLog.h"
#include "host/ModelScene.h"

namespace aolib {
namespace {

/// A part of the state: what HostState calls its values, and what GL is asked for only because of
/// it.
struct Part {
    const char* name;
    bool StateTrust::*trusted;
    std::vector<std::string> values;
    std::vector<GLenum> queries;
};

const std::vector<Part>& parts() {
    static const std::vector<Part> all{
        {"framebuffers",
         &StateTrust::framebuffers,
         {"GL_DRAW_FRAMEBUFFER_BINDING", "GL_READ_FRAMEBUFFER_BINDING", "GL_DRAW_BUFFER",
          "GL_READ_BUFFER", "GL_COLOR_ATTACHMENT0", "GL_COLOR_ATTACHMENT1", "GL_COLOR_ATTACHMENT2",
          "GL_DEPTH_ATTACHMENT", "GL_STENCIL_ATTACHMENT", "GL_STENCIL_REF", "GL_STENCIL_BACK_REF"},
         {GL_READ_FRAMEBUFFER_BINDING}},
        {"programs",
         &StateTrust::programs,
         {"GL_CURRENT_PROGRAM",
          "GL_VERTEX_ARRAY_BINDING",
          "GL_ARRAY_BUFFER_BINDING",
          "GL_ELEMENT_ARRAY_BUFFER_BINDING",
          "GL_VERTEX_ATTRIB_ARRAY_ENABLED",
          "GL_VERTEX_ATTRIB_ARRAY_SIZE",
          "GL_VERTEX_ATTRIB_ARRAY_STRIDE",
          "GL_VERTEX_ATTRIB_ARRAY_TYPE",
          "GL_VERTEX_ATTRIB_ARRAY_NORMALIZED",
          "GL_VERTEX_ATTRIB_ARRAY_INTEGER",
          "GL_VERTEX_ATTRIB_ARRAY_DIVISOR",
          "GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING",
          "GL_VERTEX_ATTRIB_ARRAY_POINTER",
          "kVertexArray",
          "kNormalArray",
          "kColorArray",
          "kIndexArray",
          "kEdgeFlagArray",
          "kTextureCoordArray",
          "kVertexArrayStride"},
         {GL_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BINDING}},
        {"textures",
         &StateTrust::textures,
         {"GL_ACTIVE_TEXTURE", "GL_TEXTURE_BINDING_2D", "GL_TEXTURE_BINDING_2D_ARRAY",
          "GL_SAMPLER_BINDING"},
         {GL_ACTIVE_TEXTURE, GL_TEXTURE_BINDING_2D, GL_TEXTURE_BINDING_2D_ARRAY,
          GL_SAMPLER_BINDING}},
        {"pixels",
         &StateTrust::pixels,
         {"GL_PIXEL_PACK_BUFFER_BINDING",
          "GL_PIXEL_UNPACK_BUFFER_BINDING",
          "GL_QUERY_BUFFER_BINDING",
          "GL_CLAMP_READ_COLOR",
          "GL_PACK_ALIGNMENT",
          "GL_PACK_IMAGE_HEIGHT",
          "GL_PACK_LSB_FIRST",
          "GL_PACK_ROW_LENGTH",
          "GL_PACK_SKIP_IMAGES",
          "GL_PACK_SKIP_PIXELS",
          "GL_PACK_SKIP_ROWS",
          "GL_PACK_SWAP_BYTES",
          "GL_PACK_INVERT_MESA",
          "GL_UNPACK_ALIGNMENT",
          "GL_UNPACK_IMAGE_HEIGHT",
          "GL_UNPACK_LSB_FIRST",
          "GL_UNPACK_ROW_LENGTH",
          "GL_UNPACK_SKIP_IMAGES",
          "GL_UNPACK_SKIP_PIXELS",
          "GL_UNPACK_SKIP_ROWS",
          "GL_UNPACK_SWAP_BYTES",
          "kMapColor",
          "kMapStencil",
          "kRedScale",
          "kGreenScale",
          "kBlueScale",
          "kAlphaScale",
          "kDepthScale",
          "and its bias"},
         {GL_PIXEL_PACK_BUFFER_BINDING, GL_PACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH,
          GL_CLAMP_READ_COLOR, GL_QUERY_BUFFER_BINDING}},
        {"depth",
         &StateTrust::depth,
         {"GL_DEPTH_TEST", "GL_DEPTH_WRITEMASK", "GL_DEPTH_FUNC", "GL_DEPTH_CLAMP",
          "GL_STENCIL_TEST"},
         {GL_DEPTH_TEST, GL_DEPTH_WRITEMASK, GL_DEPTH_FUNC, GL_DEPTH_CLAMP, GL_STENCIL_TEST}},
        {"blending",
         &StateTrust::blending,
         {"GL_BLEND", "GL_COLOR_WRITEMASK", "GL_BLEND_SRC_RGB", "GL_BLEND_DST_RGB",
          "GL_BLEND_SRC_ALPHA", "GL_BLEND_DST_ALPHA", "GL_BLEND_EQUATION_RGB",
          "GL_BLEND_EQUATION_ALPHA", "GL_COLOR_LOGIC_OP", "GL_DITHER", "GL_FRAMEBUFFER_SRGB",
          "kAlphaTest"},
         {GL_BLEND, GL_COLOR_WRITEMASK, GL_BLEND_SRC_RGB, GL_BLEND_EQUATION_RGB, GL_COLOR_LOGIC_OP,
          GL_DITHER}},
        {"raster",
         &StateTrust::raster,
         {"GL_CULL_FACE",
          "GL_FRONT_FACE",
          "GL_POLYGON_OFFSET_FILL",
          "GL_POLYGON_OFFSET_LINE",
          "GL_POLYGON_OFFSET_POINT",
          "GL_POLYGON_SMOOTH",
          "GL_POLYGON_MODE",
          "GL_LINE_SMOOTH",
          "GL_LINE_WIDTH",
          "GL_SAMPLE_ALPHA_TO_ONE",
          "GL_SAMPLE_ALPHA_TO_COVERAGE",
          "GL_SAMPLE_COVERAGE",
          "GL_SAMPLE_MASK",
          "GL_SAMPLE_SHADING",
          "GL_MULTISAMPLE",
          "GL_RASTERIZER_DISCARD",
          "GL_PRIMITIVE_RESTART",
          "GL_PRIMITIVE_RESTART_FIXED_INDEX",
          "GL_PROVOKING_VERTEX",
          "GL_CLIP_DISTANCE",
          "GL_CLIP_ORIGIN",
          "GL_CLIP_DEPTH_MODE",
          "kPolygonStipple",
          "kLineStipple",
          "kClampFragmentColor"},
         {GL_CULL_FACE, GL_FRONT_FACE, GL_POLYGON_MODE, GL_LINE_WIDTH, GL_MULTISAMPLE,
          GL_PROVOKING_VERTEX, GL_CLIP_DISTANCE0}},
        {"viewports",
         &StateTrust::viewports,
         {"GL_VIEWPORT", "GL_DEPTH_RANGE", "GL_SCISSOR_TEST"},
         {}}};
    return all;
}

/// "GL_BLEND" of "GL_BLEND[3].1".
std::string family(const std::string& name) {
    return name.substr(0, name.find_first_of("[."));
}

class TrustGLTest : public HostTest {
protected:
    void SetUp() override {
        HostTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) {
            return;
        }
        log_.emplace(loader);
        ao_.emplace(std::move(*AmbientOcclusion::create(log_->loader(), smallOptions())));
        EXPECT_TRUE(host::describeScene(*ao_, guestScene(), host::SceneNormals::Geometric).ok());
        EXPECT_TRUE(ao_->aoSetCamera(Guest::view(), Guest::projection()).ok());
    }
    void TearDown() override {
        ao_.reset();
        log_.reset();
        HostTest::TearDown();
    }
    AoStatus frame() {
        (void)ao_->aoDrawBegin();
        return ao_->aoDrawEnd(Guest::eye().x, Guest::eye().y, Guest::eye().z);
    }
    /// Uploads, reads back, draws to one target and to two. The frame comes first: it is drawn to
    /// what the host has bound.
    void work(Dice& dice) {
        EXPECT_TRUE(frame().ok()) << ao_->lastStatus().message();
        EXPECT_TRUE(ao_->addCubeMap({static_cast<float>(dice.between(-3, 3)), 3, 3}).ok());
        EXPECT_TRUE(ao_->readVisibility().ok());
        EXPECT_TRUE(ao_->readCubeMap(ao_->cubeMaps().front().id).ok());
        EXPECT_TRUE(ao_->clear().ok());
    }
    void trust(const StateTrust& trusted) {
        Options options = ao_->options();
        options.trust = trusted;
        EXPECT_TRUE(ao_->setOptions(options).ok());
    }
    /// Works in random states. @return the families of values that were not restored.
    std::set<std::string> changedBy(const std::vector<std::string>& names) {
        std::set<std::string> changed;
        log_->clear();
        for (unsigned seed = 0; seed < 6; ++seed) {
            Dice dice(seed);
            poison->apply(dice, HostView{});
            const HostState::Snapshot before = state->snapshot();
            work(dice);
            const HostState::Snapshot after = state->snapshot();
            for (std::size_t i = 0; i < before.size(); ++i) {
                if (before[i] != after[i]) {
                    changed.insert(family(names[i]));
                }
            }
            poison->release();
            EXPECT_EQ(takeError(), static_cast<GLenum>(GL_NO_ERROR)) << "seed " << seed;
        }
        poison->calm();
        return changed;
    }

    std::optional<QueryLog> log_;
    std::optional<AmbientOcclusion> ao_;
};

TEST_P(TrustGLTest, WhatIsTrustedIsLeftAloneAndAllElseRestored) {
    const std::vector<std::string> names = state->names();
    EXPECT_EQ(changedBy(names), std::set<std::string>()) << "nothing is trusted";
    for (const Part& part : parts()) {
        StateTrust trusted;
        trusted.*part.trusted = true;
        trust(trusted);
        const std::set<std::string> changed = changedBy(names);
        EXPECT_FALSE(changed.empty()) << part.name << " was restored all the same";
        for (const std::string& name : changed) {
            EXPECT_NE(std::find(part.values.begin(), part.values.end(), name), part.values.end())
                << name << " is none of " << part.name;
        }
        for (const GLenum query : part.queries) {
            EXPECT_EQ(log_->asked.count(query), 0U) << part.name << " was asked for: " << query;
        }
    }
}

TEST_P(TrustGLTest, AllPartsTogetherAreAllThatIsNotRestored) {
    StateTrust all;
    std::set<std::string> known;
    for (const Part& part : parts()) {
        all.*part.trusted = true;
        known.insert(part.values.begin(), part.values.end());
    }
    trust(all);
    for (const std::string& name : changedBy(state->names())) {
        EXPECT_EQ(known.count(name), 1U) << name;
    }
}

TEST_P(TrustGLTest, ResultsDoNotDependOnIt) {
    poison->calm();
    EXPECT_TRUE(frame().ok());
    const auto plain = ao_->readVisibility()->visibility;
    StateTrust all;
    for (const Part& part : parts()) {
        all.*part.trusted = true;
    }
    trust(all);
    for (unsigned seed = 0; seed < 4; ++seed) {
        Dice dice(seed);
        poison->apply(dice, HostView{});
        EXPECT_TRUE(frame().ok());
        EXPECT_TRUE(ao_->readVisibility()->visibility == plain) << "seed " << seed;
        poison->release();
    }
    poison->calm();
}

TEST_P(TrustGLTest, AFrameAtRestAsksForLittle) {
    poison->calm();
    for (int i = 0; i < 40 && !(i > 4 && ao_->statistics().converged); ++i) {
        EXPECT_TRUE(frame().ok());
    }
    const auto fewest = [&] {
        int least = 1000;
        for (int i = 0; i < 8; ++i) {
            poison->calm(); // a host sets what it is trusted with
            log_->clear();
            EXPECT_TRUE(frame().ok());
            least = std::min(least, log_->queries);
        }
        return least;
    };
    const int usual = fewest();
    EXPECT_LT(usual, host->has.compatibility ? 140 : 100);
    StateTrust all;
    for (const Part& part : parts()) {
        all.*part.trusted = true;
    }
    trust(all);
    EXPECT_LT(fewest(), usual / 2);
}

TEST_P(TrustGLTest, DebugGroupsCanBeSwitchedOff) {
    if (!host->has.debug) {
        GTEST_SKIP() << "this context knows no debug groups";
    }
    poison->calm();
    log_->clear();
    EXPECT_TRUE(frame().ok());
    EXPECT_GT(log_->groups, 0);
    EXPECT_EQ(log_->asked.count(GL_DEBUG_GROUP_STACK_DEPTH), 1U);
    Options options = ao_->options();
    options.debugGroups = false;
    EXPECT_TRUE(ao_->setOptions(options).ok());
    log_->clear();
    EXPECT_TRUE(frame().ok());
    EXPECT_EQ(log_->groups, 0);
    EXPECT_EQ(log_->asked.count(GL_DEBUG_GROUP_STACK_DEPTH), 0U);
}

AOLIB_FOR_ALL_CONTEXTS(TrustGLTest);

} // namespace
} // namespace aolib
