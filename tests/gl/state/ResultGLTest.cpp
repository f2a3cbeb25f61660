// What aolib computes does not depend on the state that the host is in.
#include <algorithm>
#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "Guest.h"
#include "HostTest.h"
#include "host/HostRenderer.h"
#include "host/ModelScene.h"

namespace aolib {
namespace {

/// What a framebuffer holds: colours of every attachment, depth, stencil.
struct Contents {
    std::vector<std::vector<float>> colours; ///< RGBA
    std::vector<float> depth;
    std::vector<GLubyte> stencil;
};

/// "3 of 576 values, by up to 0.1"; empty when all are equal.
template <typename T>
std::string difference(const std::vector<T>& a, const std::vector<T>& b) {
    if (a.size() != b.size()) {
        return std::to_string(a.size()) + " and " + std::to_string(b.size()) + " values";
    }
    int count = 0;
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        count += a[i] != b[i] ? 1 : 0;
        most = std::max(most, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
    }
    return count == 0 ? std::string()
                      : std::to_string(count) + " of " + std::to_string(a.size()) +
                            " values, by up to " + std::to_string(most);
}

/// Views that a result may legitimately depend on, one after the other.
std::vector<HostView> views(const HostGl& gl) {
    std::vector<HostView> all{
        {.target = HostTarget::Plain},
        {.target = HostTarget::Srgb, .srgb = true},
        {.target = HostTarget::Multisampled},
        {.target = HostTarget::ManyColours, .depthRange = {0.25, 0.75}},
        {.target = HostTarget::FloatColour, .viewport = {3, 2, 20, 12}},
        {.target = HostTarget::Plain, .scissor = {4, 3, 17, 9}, .scissorTest = true}};
    if (gl.has.clipControl) {
        all.push_back({.target = HostTarget::FloatColour, .upperLeft = true, .zeroToOne = true});
    }
    return all;
}

class ResultGLTest : public HostTest {
protected:
    static constexpr std::size_t kPixels = std::size_t{HostObjects::kWidth} * HostObjects::kHeight;

    void SetUp() override {
        HostTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) {
            return;
        }
        auto renderer = host::HostRenderer::create(gl, guestScene());
        ASSERT_TRUE(renderer.ok()) << renderer.status().message();
        renderer_.emplace(std::move(*renderer));
    }
    void TearDown() override {
        renderer_.reset();
        HostTest::TearDown();
    }

    AmbientOcclusion make(Backbone backbone, Estimator estimator) {
        Options options = smallOptions();
        options.backbone = backbone;
        options.estimator = estimator;
        options.cubeMaps.coverage = 0.0F; // placed in an empty scene only: no matter of timing
        auto ao = AmbientOcclusion::create(loader, options);
        EXPECT_TRUE(ao.ok()) << ao.status().message();
        meshes_ = *host::describeScene(*ao, guestScene(), host::SceneNormals::Geometric);
        EXPECT_TRUE(ao->aoSetCamera(Guest::view(), Guest::projection()).ok());
        return std::move(*ao);
    }
    void draw(const HostView& view) {
        poison->calm(view);
        const std::array<GLfloat, 4> grey{0.5F, 0.25F, 0.125F, 0.75F};
        for (GLint i = 0; i < (view.target == HostTarget::ManyColours ? 2 : 1); ++i) {
            host->ClearBufferfv(GL_COLOR, i, grey.data());
        }
        const GLenum first = GL_COLOR_ATTACHMENT0;
        host->DrawBuffers(1, &first); // the renderer's shader writes one colour
        renderer_->draw(Guest::view(), Guest::projection());
        poison->calm(view);
    }
    Contents read(const HostView& view);

    std::optional<host::HostRenderer> renderer_;
    std::vector<MeshId> meshes_;
};

Contents ResultGLTest::read(const HostView& view) {
    poison->calm(view);
    HostTarget target = view.target;
    if (target == HostTarget::Multisampled) { // resolve into another
        target = HostTarget::Plain;
        host->BindFramebuffer(GL_DRAW_FRAMEBUFFER, objects->framebuffer(target));
        host->BlitFramebuffer(0, 0, HostObjects::kWidth, HostObjects::kHeight, 0, 0,
                              HostObjects::kWidth, HostObjects::kHeight,
                              GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT,
                              GL_NEAREST);
    }
    host->BindFramebuffer(GL_READ_FRAMEBUFFER, objects->framebuffer(target));
    const auto pixels = [&](GLenum format, GLenum type, void* to) {
        host->ReadPixels(0, 0, HostObjects::kWidth, HostObjects::kHeight, format, type, to);
    };
    Contents contents;
    const int colours = target == HostTarget::ManyColours ? HostObjects::kColours : 1;
    for (int i = 0; i < colours; ++i) {
        host->ReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
        pixels(GL_RGBA, GL_FLOAT, contents.colours.emplace_back(4 * kPixels).data());
    }
    host->ReadBuffer(GL_COLOR_ATTACHMENT0);
    contents.depth.resize(kPixels);
    pixels(GL_DEPTH_COMPONENT, GL_FLOAT, contents.depth.data());
    if (target != HostTarget::ManyColours) {
        host->PixelStorei(GL_PACK_ALIGNMENT, 1);
        contents.stencil.resize(kPixels);
        pixels(GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, contents.stencil.data());
    }
    return contents;
}

/// A step that both instances take, each in its own state.
void step(AmbientOcclusion& ao, const std::vector<MeshId>& meshes, unsigned seed) {
    Dice dice(1000003U * (seed + 1));
    const auto coordinate = [&] { return static_cast<float>(dice.between(-20, 20)) * 0.1F; };
    Options options = ao.options();
    switch (dice.between(0, 5)) {
    case 0:
        EXPECT_TRUE(ao.clear().ok());
        break;
    case 1:
        if (options.backbone == Backbone::Cubemapped && ao.cubeMaps().size() < 3) {
            EXPECT_TRUE(ao.addCubeMap({coordinate(), 3.0F + coordinate(), coordinate()}).ok());
        }
        break;
    case 2:
        EXPECT_TRUE(ao.moveMesh(meshes[1],
                                glm::translate(glm::mat4(1.0F), {coordinate(), 0.0F, coordinate()}))
                        .ok());
        break;
    case 3:
        options.cubeMaps.faceSize = options.cubeMaps.faceSize == 16 ? 20 : 16;
        options.horizonSplit.directions = dice.between(1, 2);
        EXPECT_TRUE(ao.setOptions(options).ok());
        break;
    case 4:
        options.debugView =
            dice.chance(0.5) ? DebugView::Off : kDebugViewChoices[dice.below(8)].value;
        options.cubeMaps.outlines = dice.chance(0.5);
        options.blur.enabled = dice.chance(0.7);
        EXPECT_TRUE(ao.setOptions(options).ok());
        break;
    default:
        break;
    }
}

TEST_P(ResultGLTest, APoisonedHostGetsWhatACalmOneGets) {
    const std::vector<HostView> all = views(*host);
    const std::pair<Backbone, Estimator> strategies[] = {
        {Backbone::Cubemapped, Estimator::HorizonSplit},
        {Backbone::Cubemapped, Estimator::LayeredIntervals},
        {Backbone::ScreenSpace, Estimator::HorizonSplit}};
    for (const auto& [backbone, estimator] : strategies) {
        AmbientOcclusion poisoned = make(backbone, estimator);
        AmbientOcclusion calm = make(backbone, estimator);
        bool darkened = false;
        for (unsigned seed = 0; seed < seeds(80); ++seed) {
            const HostView& view = all[seed % all.size()];
            const std::string where =
                std::string(backbone == Backbone::Cubemapped ? "" : "screen space, ") +
                (estimator == Estimator::HorizonSplit ? "" : "layered, ") + "seed " +
                std::to_string(seed);
            const glm::vec3 eye = Guest::eye();

            draw(view);
            const Contents drawn = read(view);
            step(calm, meshes_, seed);
            ASSERT_TRUE(calm.aoDrawBegin().ok());
            poison->calm(view);
            ASSERT_TRUE(calm.aoDrawEnd(eye.x, eye.y, eye.z).ok()) << calm.lastStatus().message();
            const VisibilityImage expected = *calm.readVisibility();
            const Contents wanted = read(view);

            draw(view);
            Dice dice(seed);
            poison->apply(dice, view);
            step(poisoned, meshes_, seed);
            ASSERT_TRUE(poisoned.aoDrawBegin().ok());
            ASSERT_TRUE(poisoned.aoDrawEnd(eye.x, eye.y, eye.z).ok())
                << where << ": " << poisoned.lastStatus().message();
            const VisibilityImage got = *poisoned.readVisibility();
            const auto cubes = poisoned.cubeMaps();
            if (!cubes.empty()) {
                const CubeMapImage a = *poisoned.readCubeMap(cubes.front().id);
                poison->calm(view);
                const CubeMapImage b = *calm.readCubeMap(calm.cubeMaps().front().id);
                EXPECT_EQ(difference(a.visibility, b.visibility), "") << where;
                EXPECT_EQ(difference(a.distance, b.distance), "") << where;
            }
            const Contents found = read(view);

            EXPECT_EQ(got.width, view.viewport[2]) << where;
            EXPECT_EQ(difference(got.visibility, expected.visibility), "")
                << where << ": visibility";
            EXPECT_EQ(difference(found.colours[0], wanted.colours[0]), "") << where << ": colours";
            EXPECT_EQ(difference(found.depth, drawn.depth), "") << where << ": the host's depth";
            EXPECT_EQ(difference(found.stencil, drawn.stencil), "")
                << where << ": the host's stencil";
            for (std::size_t i = 1; i < drawn.colours.size(); ++i) {
                EXPECT_EQ(difference(found.colours[i], drawn.colours[i]), "")
                    << where << ": colour " << i;
            }
            bool alpha = true;
            for (std::size_t i = 3; i < drawn.colours[0].size(); i += 4) {
                alpha = alpha && found.colours[0][i] == drawn.colours[0][i];
            }
            EXPECT_TRUE(alpha) << where << ": the host's alpha";
            darkened = darkened || found.colours[0] != drawn.colours[0];
            ASSERT_FALSE(HasFailure());
        }
        EXPECT_TRUE(darkened) << "the test would see nothing";
        poison->calm();
    }
}

TEST_P(ResultGLTest, CubeMapsDoNotDependOnHowTheHostLooks) {
    for (const Estimator estimator : {Estimator::HorizonSplit, Estimator::LayeredIntervals}) {
        AmbientOcclusion ao = make(Backbone::Cubemapped, estimator);
        const auto build = [&] {
            const Result<CubeMapId> id = ao.addCubeMap({1, 3, 2});
            EXPECT_TRUE(id.ok()) << id.status().message();
            CubeMapImage image = *ao.readCubeMap(*id);
            EXPECT_TRUE(ao.clear().ok());
            return image;
        };
        poison->calm();
        const CubeMapImage expected = build();
        for (unsigned seed = 0; seed < seeds(60) && !HasFailure(); ++seed) {
            Dice dice(seed);
            HostView view = poison->randomView(dice);
            view.target = HostTarget::Plain; // drivers complain about those that are incomplete
            poison->apply(dice, view);
            const CubeMapImage got = build();
            EXPECT_EQ(difference(got.visibility, expected.visibility), "") << "seed " << seed;
            EXPECT_EQ(difference(got.distance, expected.distance), "") << "seed " << seed;
        }
        poison->calm();
    }
}

AOLIB_FOR_ALL_CONTEXTS(ResultGLTest);

} // namespace
} // namespace aolib
