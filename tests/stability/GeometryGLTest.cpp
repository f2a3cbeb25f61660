// Geometry that rounding, sampling or peeling may stumble over, against ray tracing.
#include "Figures.h"
#include "HardScenes.h"

namespace aolib {
namespace {

class GeometryGLTest : public StabilityTest {
protected:
    static constexpr float kRadius = 2.0F;
    const std::vector<glm::vec3> cubeMaps_{{0, 3, 7}, {6, 2, 0}};

    static NamedCamera camera(const glm::vec3& eye, const glm::vec3& target) {
        NamedCamera camera;
        camera.eye = eye;
        camera.target = target;
        camera.fovyDeg = 60.0F;
        camera.near = 0.02F;
        camera.far = 100.0F;
        return camera;
    }
    /// The picture's error, said and bound.
    Error bounded(const Shot& shot, const Model& model, const Options& o, const std::string& what,
                  double bound) {
        const Error error = errorOf(shot, model, o);
        report(what + " rmse", error.rmse);
        report(what + " mean", error.mean);
        EXPECT_LE(error.rmse, bound) << what;
        EXPECT_LE(error.mismatched, 0.002) << what;
        return error;
    }
};

TEST_P(GeometryGLTest, GrazingAngles) {
    for (const float height : {0.5F, 0.05F, 0.005F}) {
        const NamedCamera low = camera({0, height, 7}, {0.5F, height * 0.9F, -8});
        const Shot shot = shoot(court(), options(kRadius), low, {low.eye});
        bounded(shot, court(), options(kRadius), "height " + std::to_string(height),
                forEach(0.14, 0.027, 0.024));
    }
}

TEST_P(GeometryGLTest, NearAndFarPlaneNineOrdersOfMagnitudeApart) {
    // At the far wall 24 bits of depth are 0.013 and 1.3 apart, a texel is 0.2 and 2.3 wide.
    for (const float scale : {1.0F, 10.0F}) {
        NamedCamera wide = scaled(courtCamera(), scale);
        wide.near = 1e-3F;
        wide.far = 1e6F;
        const Model model = scaled(court(), scale);
        Options o = options(scale * kRadius);
        o.cubeMaps.faceSize = 128;
        const Shot shot = shoot(model, o, wide, {scale * cubeMaps_[0], scale * cubeMaps_[1]});
        bounded(shot, model, o, "scale " + std::to_string(scale), forEach(0.1, 0.015, 0.015));
    }
}

TEST_P(GeometryGLTest, EverythingTwiceIsAsOnce) {
    Model twice = court();
    for (const ModelMesh& mesh : court().meshes) {
        twice.meshes.push_back(mesh);
    }
    const Shot before = shoot(court(), options(kRadius), courtCamera(), cubeMaps_);
    const Shot after = shoot(twice, options(kRadius), courtCamera(), cubeMaps_);
    const Change change = changeOf(before.picture.visibility, after.picture.visibility);
    report("max change", change.max);
    // Rays: a texel right on an edge takes the one triangle or the other.
    EXPECT_LE(change.p99, 1.0 / 255.0);
    EXPECT_LE(change.max, forEach(1.0 / 255.0, 1.0 / 255.0, 0.05));
    bounded(after, court(), options(kRadius), "twice", forEach(0.095, 0.022, 0.022));
}

TEST_P(GeometryGLTest, SurfacesThatFightForDepth) {
    for (const float lift : {1e-7F, 1e-5F, 1e-3F}) {
        Model model = court();
        addQuad(model, {-7, lift, -6}, {-7, lift, 6}, {7, lift, 6}, {7, lift, -6});
        const Shot shot = shoot(model, options(kRadius), courtCamera(), cubeMaps_);
        bounded(shot, court(), options(kRadius), "lift " + std::to_string(lift),
                forEach(0.095, 0.022, 0.022));
    }
}

TEST_P(GeometryGLTest, FinsThinnerThanATexel) {
    for (const float thickness : {0.1F, 0.01F, 0.001F}) {
        const Model model = fins(thickness, 0.25F);
        const Options o = options(1.0F);
        const Shot shot = shoot(model, o, camera({1.5F, 3, 4}, {0, 0.5F, 0}), {{1.5F, 3, 4}});
        bounded(shot, model, o, "thickness " + std::to_string(thickness),
                forEach(0.52, 0.29, 0.165));
    }
}

TEST_P(GeometryGLTest, LeavesSmallerThanATexel) {
    for (const float size : {0.2F, 0.05F, 0.01F}) {
        const Model model = leaves(static_cast<int>(40.0F / (size * size * 10.0F)), size);
        const Options o = options(1.0F);
        const Shot shot = shoot(model, o, camera({1.5F, 3, 4}, {0, 0.5F, 0}), {{1.5F, 3, 4}});
        bounded(shot, model, o, "size " + std::to_string(size), forEach(0.065, 0.058, 0.055));
    }
}

TEST_P(GeometryGLTest, TrianglesWithoutAreaAndSliversChangeNothing) {
    Model model = court();
    ModelMesh mesh;
    const auto triangle = [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
        for (const glm::vec3& p : {a, b, c}) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.push_back(p);
        }
    };
    for (int i = 0; i < 64; ++i) {
        const float x = -6.0F + 0.2F * static_cast<float>(i);
        triangle({x, 1, 2}, {x, 1, 2}, {x, 1, 2});                   // a point
        triangle({x, 0, 3}, {x, 2, 3}, {x, 1, 3});                   // a line
        triangle({x, 0, -2}, {x, 0, -2}, {x, 3, -2});                // an edge twice
        triangle({x, 0, 6}, {x + 1e-6F, 0, 6}, {x, 0, -2});          // a sliver in the floor
        triangle({x, 0.5F, 4}, {x, 0.5F + 1e-6F, 4}, {x + 3, 1, 4}); // and one in the air
    }
    // And within the mesh of a box, whose surface it does not open.
    ModelMesh& box = model.meshes.back();
    const std::uint32_t first = box.indices[0];
    box.indices.insert(box.indices.end(), {first, first, first, first, first, box.indices[1]});
    model.meshes.push_back(std::move(mesh));
    const Shot before = shoot(court(), options(kRadius), courtCamera(), cubeMaps_);
    const Shot after = shoot(model, options(kRadius), courtCamera(), cubeMaps_);
    const Change change = changeOf(before.picture.visibility, after.picture.visibility);
    report("max change", change.max);
    // Rays: a texel right on an edge takes the one triangle or the other.
    EXPECT_LE(change.p99, 1.0 / 255.0);
    EXPECT_LE(change.above, 0.01); // a texel shades 0.0055 of the pixels
    EXPECT_LE(change.max, forEach(1.0 / 255.0, 1.0 / 255.0, 0.05));
    bounded(after, court(), options(kRadius), "slivers", forEach(0.095, 0.022, 0.022));
}

TEST_P(GeometryGLTest, WhatLiesBeyondTheRadiusAndOutOfSightChangesNothing) {
    const Shot before = shoot(court(), options(kRadius), courtCamera(), cubeMaps_);
    for (const float x : {9.6F, 50.0F, 3000.0F}) {
        Model model = court();
        addQuad(model, {x, 0.5F, 4}, {x, 0.5F, 4.01F}, {x, 0.51F, 4.01F}, {x, 0.51F, 4});
        const Shot after = shoot(model, options(kRadius), courtCamera(), cubeMaps_);
        const Change change = changeOf(before.picture.visibility, after.picture.visibility);
        report("max change at x = " + std::to_string(x), change.max);
        // Rays: as above.
        EXPECT_LE(change.p99, 1.0 / 255.0) << x;
        EXPECT_LE(change.max, forEach(1.0 / 255.0, 1.0 / 255.0, 0.05)) << x;
    }
}

TEST_P(GeometryGLTest, CubeMapsWhereNoneShouldStand) {
    const struct {
        const char* name;
        glm::vec3 at;
    } places[] = {{"on the floor", {0, 0, 3}},
                  {"on a side", {-2, 2, -3}},
                  {"on an edge", {-1, 3, -3}},
                  {"on a vertex", {4, 2, -1}},
                  {"in a corner", {7.999F, 0.001F, -6.999F}},
                  {"in a solid", {-2.5F, 1.5F, -4}},
                  {"in a wall", {0, 2.5F, -7.5F}},
                  {"below the floor", {0, -1, 0}},
                  {"far away", {0, 1000, 0}}};
    for (const auto& place : places) {
        // Alone it leaves open what it cannot tell; beside better ones it does little harm.
        const Shot alone = shoot(court(), options(kRadius), courtCamera(), {place.at});
        const Error error = errorOf(alone, court(), options(kRadius));
        report(std::string(place.name) + " alone mean", error.mean);
        EXPECT_GE(error.mean, -0.03) << place.name;
        const Shot beside =
            shoot(court(), options(kRadius), courtCamera(), {cubeMaps_[0], cubeMaps_[1], place.at});
        bounded(beside, court(), options(kRadius), place.name, forEach(0.135, 0.055, 0.05));
    }
}

TEST_P(GeometryGLTest, TheNearPlaneCutsThroughWhatIsSeen) {
    for (const float near : {4.0F, 9.0F, 12.0F}) {
        NamedCamera cut = courtCamera();
        cut.near = near;
        // The insides of the solids show: cube maps in there know them.
        std::vector<glm::vec3> cubeMaps = cubeMaps_;
        cubeMaps.insert(cubeMaps.end(), {{-2.5F, 1.5F, -4}, {2.5F, 1, -2}, {0, 2.5F, -7.5F}});
        const Shot shot = shoot(court(), options(kRadius), cut, cubeMaps);
        bounded(shot, court(), options(kRadius), "near " + std::to_string(near),
                forEach(0.21, 0.08, 0.08));
    }
}

TEST_P(GeometryGLTest, ACameraInsideASolid) {
    const NamedCamera inside = camera({-2.5F, 1.5F, -4}, {-1, 0, -3});
    const Shot shot = shoot(court(), options(kRadius), inside, {inside.eye});
    bounded(shot, court(), options(kRadius), "inside", forEach(0.5, 0.035, 0.02));
}

AOLIB_FOR_ALL_ESTIMATORS(GeometryGLTest);

} // namespace
} // namespace aolib
