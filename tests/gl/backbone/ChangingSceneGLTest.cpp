// Scenes in which something changes in every frame: computing goes on, and what the change does not
// touch converges.
#include "ProgressiveTest.h"

namespace aolib {
namespace {

/// Beside the path of the box, two radii from it and more.
constexpr glm::vec3 kFar[]{{-6, 0, 1}, {6, 0, 1}, {-6, 0, -1.9F}, {6, 0, -1.9F}, {-5.5F, 0, 3}};

/// Where its shadow falls.
glm::vec3 beforeBox(float x) {
    return {x, 0, 1.65F};
}

/// A floor with a wall at its back, and a box of half a unit that can be moved along it.
class ChangingSceneGLTest : public ProgressiveTest {
protected:
    static constexpr float kRadius = 1.0F;
    static constexpr glm::vec3 kEye{0, 5, 8};

    static Model room() {
        Model model;
        addBox(model, {-8, -0.2F, -8}, {8, 0, 8});
        addBox(model, {-8, 0, -3}, {8, 2, -2});
        return model;
    }
    static constexpr int kFramesInARow = 40;

    static Options options(Estimator estimator) {
        Options o = ProgressiveTest::options(estimator);
        o.radius = kRadius;
        o.cubeMaps.place = true;
        o.cubeMaps.refineStaticViews = false;
        o.rayTraced.rays = 64;
        return o;
    }
    static glm::mat4 at(float x, float y = 0.0F) {
        return glm::translate(glm::mat4(1.0F), {x, y, 1.0F});
    }
    static MeshData box(const glm::mat4& transform) {
        static const Model model = [] {
            Model made;
            addBox(made, {-0.5F, 0, -0.5F}, {0.5F, 1, 0.5F});
            return made;
        }();
        const ModelMesh& mesh = model.meshes.front();
        return {mesh.positions, {}, mesh.indices, transform};
    }
    SmallHost hostOf(const Options& o) {
        SmallHost host = hostWith(o, room());
        host.lookAt(kEye, {0, 0.3F, 0});
        return host;
    }
    void frame(SmallHost& host) {
        const AoStatus status = host.frame();
        ASSERT_TRUE(status.ok()) << status.message();
        gl.Finish();
        std::this_thread::sleep_for(std::chrono::milliseconds(1)); // for the tracer's worker
    }
    /// Moves the box to and fro in every frame until something holds. @return whether it ever did.
    template <typename Condition>
    bool moveUntil(SmallHost& host, MeshId id, Condition holds, float y = 0.0F) {
        for (int i = 0; i < kMostFrames; ++i, ++step_) {
            EXPECT_TRUE(host.ao().moveMesh(id, at(position(), y)).ok());
            frame(host);
            if (HasFatalFailure() || holds()) {
                return !HasFatalFailure();
            }
        }
        return false;
    }
    float position() const { return 0.5F * std::sin(0.03F * static_cast<float>(step_)); }
    int step_ = 0;

    void computesFromTheFirstFrameOn(Estimator estimator) {
        SmallHost host = hostOf(options(estimator));
        const MeshId id = *host.ao().addMesh(box(at(0)));
        EXPECT_TRUE(moveUntil(host, id, [&] { return host.ao().statistics().coverage > 0.95F; }));
        EXPECT_FALSE(host.ao().statistics().converged);
    }
    void restConverges(Estimator estimator, float tolerance) {
        const Options o = options(estimator);
        SmallHost still = hostOf(o);
        ASSERT_TRUE(still.ao().addMesh(box(at(0))).ok());
        ASSERT_GT(converge(still), 0);
        SmallHost host = hostOf(o);
        const MeshId id = *host.ao().addMesh(box(at(0)));
        const auto converged = [&] {
            return std::ranges::all_of(kFar, [&](const glm::vec3& point) {
                return std::abs(host.visibilityAt(point) - still.visibilityAt(point)) <= tolerance;
            });
        };
        // A value that is near the last one by chance is not there yet: passes go on.
        int inARow = 0;
        EXPECT_TRUE(moveUntil(host, id, [&] {
            inARow = converged() ? inARow + 1 : 0;
            return inARow >= kFramesInARow;
        }));
        // It stays so.
        int worse = 0;
        for (int i = 0; i < 30; ++i) {
            (void)moveUntil(host, id, [] { return true; });
            worse += converged() ? 0 : 1;
        }
        EXPECT_EQ(worse, 0);
        // And the last picture is that of the scene as it stands.
        ASSERT_TRUE(host.ao().moveMesh(id, at(0)).ok());
        ASSERT_GT(converge(host), 0);
        EXPECT_LT(rmse(host.visibility().visibility, still.visibility().visibility),
                  0.2F * tolerance + 0.001F);
    }
    void shadowFollows(Estimator estimator) {
        SmallHost host = hostOf(options(estimator));
        const MeshId id = *host.ao().addMesh(box(at(-3)));
        ASSERT_GT(converge(host), 0);
        const float open = host.visibilityAt(beforeBox(1));
        ASSERT_GT(open, 0.95F);
        ASSERT_LT(host.visibilityAt(beforeBox(-3)), 0.8F);
        step_ = 0;
        const auto shaded = [&] { return host.visibilityAt(beforeBox(0)) < 0.8F; };
        EXPECT_TRUE(moveUntil(host, id, shaded)) << "its shadow comes while it moves";
        EXPECT_TRUE(moveUntil(host, id, [&] { return host.visibilityAt(beforeBox(-3)) > 0.95F; }))
            << "and does not stay where it stood";
    }
    /// Something that changes in every frame, until nearly all is shaded.
    template <typename Change>
    bool goesOnWhile(Estimator estimator, Change change) {
        SmallHost host = hostOf(options(estimator));
        for (int i = 0; i < kMostFrames; ++i) {
            change(host.ao(), i);
            frame(host);
            if (HasFatalFailure() || host.ao().statistics().coverage > 0.95F) {
                return !HasFatalFailure();
            }
        }
        return false;
    }
    void allKindsOfChangesGoOn(Estimator estimator) {
        EXPECT_TRUE(goesOnWhile(estimator, [](AmbientOcclusion& ao, int i) {
            if (i < 300) {
                EXPECT_TRUE(ao.addMesh(box(at(-7.0F + 0.04F * static_cast<float>(i)))).ok());
            } else { // enough of them
                EXPECT_TRUE(ao.moveMesh(MeshId{3}, at(0.001F * static_cast<float>(i))).ok());
            }
        })) << "a mesh is added in each frame";
        EXPECT_TRUE(goesOnWhile(estimator, [](AmbientOcclusion& ao, int i) {
            if (i == 0) {
                EXPECT_TRUE(ao.addMesh(box(at(0))).ok());
            }
            const glm::mat4 grown =
                glm::scale(at(0), glm::vec3(1.0F + 0.1F * static_cast<float>(i % 5)));
            EXPECT_TRUE(ao.replaceMesh(MeshId{3}, box(grown)).ok());
        })) << "one is replaced";
        EXPECT_TRUE(goesOnWhile(estimator, [](AmbientOcclusion& ao, int i) {
            Options o = ao.options();
            o.radius = 1.0F + 0.001F * static_cast<float>(i % 500);
            EXPECT_TRUE(ao.setOptions(o).ok());
        })) << "the radius changes";
    }
};

TEST_P(ChangingSceneGLTest, RaysGoOnFromTheFirstFrame) {
    computesFromTheFirstFrameOn(Estimator::RayTraced);
}
TEST_P(ChangingSceneGLTest, LayersGoOnFromTheFirstFrame) {
    computesFromTheFirstFrameOn(Estimator::LayeredIntervals);
}
TEST_P(ChangingSceneGLTest, HorizonsGoOnFromTheFirstFrame) {
    computesFromTheFirstFrameOn(Estimator::HorizonSplit);
}
TEST_P(ChangingSceneGLTest, RaysConvergeBesideWhatMoves) {
    restConverges(Estimator::RayTraced, 0.005F);
}
TEST_P(ChangingSceneGLTest, LayersConvergeBesideWhatMoves) {
    restConverges(Estimator::LayeredIntervals, 0.02F);
}
TEST_P(ChangingSceneGLTest, HorizonsConvergeBesideWhatMoves) {
    restConverges(Estimator::HorizonSplit, 0.02F);
}
TEST_P(ChangingSceneGLTest, ARayTracedShadowFollows) {
    shadowFollows(Estimator::RayTraced);
}
TEST_P(ChangingSceneGLTest, ALayeredShadowFollows) {
    shadowFollows(Estimator::LayeredIntervals);
}
TEST_P(ChangingSceneGLTest, NoChangeStopsRays) {
    allKindsOfChangesGoOn(Estimator::RayTraced);
}
TEST_P(ChangingSceneGLTest, NoChangeStopsLayers) {
    allKindsOfChangesGoOn(Estimator::LayeredIntervals);
}
TEST_P(ChangingSceneGLTest, NoChangeStopsHorizons) {
    allKindsOfChangesGoOn(Estimator::HorizonSplit);
}

TEST_P(ChangingSceneGLTest, WhatMovesOutOfSightDisturbsNothing) {
    Options o = options(Estimator::RayTraced);
    o.cubeMaps.refineStaticViews = true;
    SmallHost host = hostOf(o);
    const MeshId id = *host.ao().addMesh(box(at(0, -4)));
    ASSERT_TRUE(moveUntil(
        host, id, [&] { return host.ao().statistics().converged; }, -4.0F))
        << "below the floor, in every frame";
    const Picture before = host.visibility().visibility;
    for (int i = 0; i < 20; ++i) {
        (void)moveUntil(
            host, id, [] { return true; }, -4.0F);
        ASSERT_TRUE(host.ao().statistics().converged);
    }
    EXPECT_EQ(host.visibility().visibility, before);
}

TEST_P(ChangingSceneGLTest, PixelsOfAViewAtRestStayWhereNothingMoves) {
    Options o = options(Estimator::RayTraced);
    o.cubeMaps.refineStaticViews = true;
    SmallHost host = hostOf(o);
    const MeshId id = *host.ao().addMesh(box(at(0)));
    ASSERT_GT(converge(host), 0);
    const glm::vec3 edge{-5, 2, -2}; // of the wall's top, between texels
    const float refined = host.visibilityAt(edge);
    for (int i = 0; i < 20; ++i) {
        (void)moveUntil(host, id, [] { return true; });
        ASSERT_EQ(host.visibilityAt(edge), refined) << i;
    }
    ASSERT_GT(converge(host), 0) << "and all of it is refined again once it rests";
}

/// The farther a scene reaches, the coarser cube maps keep distances: they begin anew for that a
/// few times at most.
TEST_P(ChangingSceneGLTest, ASceneThatGrowsInEveryFrameKeepsWhatIsShown) {
    SmallHost host = hostOf(options(Estimator::RayTraced));
    const MeshId id = *host.ao().addMesh(box(at(20)));
    ASSERT_GT(converge(host), 0);
    int dark = 0;
    for (int i = 0; i < 60; ++i) {
        ASSERT_TRUE(host.ao().moveMesh(id, at(20.0F + 2.0F * static_cast<float>(i))).ok());
        frame(host);
        dark += host.ao().statistics().coverage < 0.95F ? 1 : 0;
    }
    EXPECT_LT(dark, 40);
    ASSERT_GT(converge(host), 0);
}

AOLIB_FOR_ALL_CONTEXTS(ChangingSceneGLTest);

} // namespace
} // namespace aolib
