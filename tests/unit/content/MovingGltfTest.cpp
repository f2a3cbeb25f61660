#include <cmath>
#include <string>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "SmallGltf.h"
#include "content/GltfReader.h"
#include "content/MovingGltf.h"
#include "content/generated/AnimatedModels.h"

namespace aolib::test {
namespace {

/// The unit square with more bytes, views and accessors (numbers 3 and up), and further members.
std::string movingQuad(const std::string& nodes, const std::string& bytes, const std::string& views,
                       const std::string& accessors, const std::string& extra,
                       const std::string& primitive = "") {
    std::string json = quadJson(nodes, extra);
    json = replaced(json, R"("byteLength":108)",
                    R"("byteLength":)" + std::to_string(108 + bytes.size()));
    json = replaced(json, R"("byteLength":12})", R"("byteLength":12})" + views);
    json = replaced(json, R"("type":"SCALAR"})", R"("type":"SCALAR"})" + accessors);
    json = replaced(json, R"("indices":2)", R"("indices":2)" + primitive);
    return packGlb(json, quadBytes() + bytes);
}

/// A view of `length` bytes at `offset` behind the square's.
std::string view(std::size_t offset, std::size_t length) {
    return R"(,{"buffer":0,"byteOffset":)" + std::to_string(108 + offset) + R"(,"byteLength":)" +
           std::to_string(length) + "}";
}

std::string accessor(int bufferView, int count, const std::string& type, int component = 5126) {
    return R"(,{"bufferView":)" + std::to_string(bufferView) + R"(,"componentType":)" +
           std::to_string(component) + R"(,"count":)" + std::to_string(count) + R"(,"type":")" +
           type + R"("})";
}

std::string animation(const std::string& path, const std::string& interpolation, int node = 0) {
    return R"(,"animations":[{"samplers":[{"input":3,"output":4,"interpolation":")" +
           interpolation + R"("}],"channels":[{"sampler":0,"target":{"node":)" +
           std::to_string(node) + R"(,"path":")" + path + R"("}}]}])";
}

/// The square, one property of its node moved by keys at 1 and 3 seconds.
std::string keyed(const std::string& path, const std::string& interpolation,
                  std::initializer_list<float> values, const std::string& type) {
    const std::string numbers = floatBytes(values);
    const int count = static_cast<int>(values.size()) / (type == "VEC4" ? 4 : 3);
    return movingQuad(
        R"([{"mesh":0}])", floatBytes({1, 3}) + numbers, view(0, 8) + view(8, numbers.size()),
        accessor(3, 2, "SCALAR") + accessor(4, count, type), animation(path, interpolation));
}

MovingGltf opened(const std::string& bytes) {
    Result<MovingGltf, LoadError> moving = MovingGltf::open(bytes, "moving.glb");
    EXPECT_TRUE(moving) << moving.error().sentence;
    return std::move(*moving);
}

/// A vertex of the first mesh in the world.
glm::vec3 vertexAt(const MovingGltf& moving, double seconds, std::size_t vertex) {
    const Result<Model, LoadError> model = moving.at(0, seconds);
    EXPECT_TRUE(model) << model.error().sentence;
    const ModelMesh& mesh = model->meshes.at(0);
    return glm::vec3(mesh.transform * glm::vec4(mesh.positions.at(vertex), 1.0F));
}

void expectNear(const glm::vec3& found, const glm::vec3& expected) {
    EXPECT_NEAR(glm::distance(found, expected), 0.0F, 1e-5F)
        << found.x << ' ' << found.y << ' ' << found.z;
}

TEST(MovingGltfTest, TranslationsAreLinearAndStandStillOutside) {
    const MovingGltf moving = opened(keyed("translation", "LINEAR", {0, 0, 0, 4, 2, 0}, "VEC3"));
    EXPECT_EQ(moving.animations(), 1U);
    EXPECT_EQ(moving.duration(0), 3.0);
    expectNear(vertexAt(moving, 0.0, 0), {0, 0, 0});
    expectNear(vertexAt(moving, 1.5, 0), {1, 0.5F, 0});
    expectNear(vertexAt(moving, 3.0, 0), {4, 2, 0});
    expectNear(vertexAt(moving, 9.0, 0), {4, 2, 0});
}

TEST(MovingGltfTest, StepsJump) {
    const MovingGltf moving = opened(keyed("scale", "STEP", {1, 1, 1, 3, 3, 3}, "VEC3"));
    expectNear(vertexAt(moving, 2.99, 1), {1, 0, 0});
    expectNear(vertexAt(moving, 3.0, 1), {3, 0, 0});
}

TEST(MovingGltfTest, RotationsGoAlongTheArc) {
    // From none to 90 degrees about z; halfway 45, a quarter 22.5.
    const float half = std::sqrt(0.5F);
    const MovingGltf moving =
        opened(keyed("rotation", "LINEAR", {0, 0, 0, 1, 0, 0, half, half}, "VEC4"));
    expectNear(vertexAt(moving, 2.0, 1), {half, half, 0});
    const float angle = glm::radians(22.5F);
    expectNear(vertexAt(moving, 1.5, 1), {std::cos(angle), std::sin(angle), 0});
    expectNear(vertexAt(moving, 3.0, 1), {0, 1, 0});
}

TEST(MovingGltfTest, CubicSplinesFollowTheirTangents) {
    // In-tangent, value, out-tangent of each key. From 0 to 1 in 2 s with slopes 1 and 0: halfway
    // 1/2 * 0 + 2 * 1/8 * 1 + 1/2 * 1 - 2 * 1/8 * 0 = 0.75.
    const MovingGltf moving =
        opened(keyed("translation", "CUBICSPLINE",
                     {9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 9, 9, 9}, "VEC3"));
    expectNear(vertexAt(moving, 1.0, 0), {0, 0, 0});
    expectNear(vertexAt(moving, 2.0, 0), {0.75F, 0, 0});
    expectNear(vertexAt(moving, 3.0, 0), {1, 0, 0});
}

TEST(MovingGltfTest, MorphTargetsAreAddedByTheirWeights) {
    const std::string offsets = floatBytes({0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    const MovingGltf moving = opened(
        movingQuad(R"([{"mesh":0}])", floatBytes({0, 1}) + floatBytes({0, 0.5F}) + offsets,
                   view(0, 8) + view(8, 8) + view(16, 48),
                   accessor(3, 2, "SCALAR") + accessor(4, 2, "SCALAR") + accessor(5, 4, "VEC3"),
                   animation("weights", "LINEAR"), R"(,"targets":[{"POSITION":5}])"));
    expectNear(vertexAt(moving, 0.0, 0), {0, 0, 0});
    expectNear(vertexAt(moving, 1.0, 0), {0, 0, 1});
    expectNear(vertexAt(moving, 0.5, 0), {0, 0, 0.5F});
    expectNear(vertexAt(moving, 1.0, 2), {1, 1, 0});
}

TEST(MovingGltfTest, SkinsFollowTheirJointsAndNotTheirNode) {
    // Vertices 0 and 1 hang on joint 0, 2 half on each, 3 on joint 1, which moves by 2 along x. The
    // mesh's node lies at x = 100, which a skin ignores.
    const std::string joints("\0\0\0\0\0\0\0\0\0\1\0\0\1\0\0\0", 16);
    const std::string weights = floatBytes({1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0, 1, 0, 0, 0});
    const std::string bytes =
        floatBytes({0, 1}) + floatBytes({0, 0, 0, 2, 0, 0}) + joints + weights;
    std::string json =
        quadJson(R"([{"mesh":0,"skin":0,"translation":[100,0,0]},{},{}])",
                 animation("translation", "LINEAR", 2) + R"(,"skins":[{"joints":[1,2]}])");
    json = replaced(json, R"("byteLength":108)",
                    R"("byteLength":)" + std::to_string(108 + bytes.size()));
    json = replaced(json, R"("byteLength":12})",
                    R"("byteLength":12})" + view(0, 8) + view(8, 24) + view(32, 16) + view(48, 64));
    json = replaced(json, R"("type":"SCALAR"})",
                    R"("type":"SCALAR"})" + accessor(3, 2, "SCALAR") + accessor(4, 2, "VEC3") +
                        accessor(5, 4, "VEC4", 5121) + accessor(6, 4, "VEC4"));
    json = replaced(json, R"("NORMAL":1)", R"("NORMAL":1,"JOINTS_0":5,"WEIGHTS_0":6)");
    const MovingGltf moving = opened(packGlb(json, quadBytes() + bytes));
    expectNear(vertexAt(moving, 0.0, 1), {1, 0, 0});
    expectNear(vertexAt(moving, 1.0, 1), {1, 0, 0});
    expectNear(vertexAt(moving, 1.0, 2), {2, 1, 0});
    expectNear(vertexAt(moving, 1.0, 3), {2, 1, 0});
    expectNear(vertexAt(moving, 0.5, 3), {1, 1, 0});
}

TEST(MovingGltfTest, AtRestItIsWhatTheReaderReads) {
    for (const std::string& name : animatedModelNames()) {
        const Result<std::string, LoadError> bytes = animatedModel(name);
        ASSERT_TRUE(bytes) << bytes.error().sentence;
        const MovingGltf moving = opened(*bytes);
        ASSERT_EQ(moving.animations(), 1U) << name;
        EXPECT_FLOAT_EQ(static_cast<float>(moving.duration(0)), 2.0F);
        const Result<Model, LoadError> rest = readGltf(*bytes, "rest.glb");
        const Result<Model, LoadError> still = moving.at(moving.animations(), 0.0);
        ASSERT_EQ(still->meshes.size(), rest->meshes.size());
        for (std::size_t i = 0; i < rest->meshes.size(); ++i) {
            EXPECT_EQ(still->meshes[i].indices, rest->meshes[i].indices);
            for (std::size_t v = 0; v < rest->meshes[i].positions.size(); ++v) {
                expectNear(still->meshes[i].positions[v], rest->meshes[i].positions[v]);
            }
        }
    }
}

TEST(MovingGltfTest, TheArmBendsAtItsElbow) {
    const MovingGltf moving = opened(*animatedModel("arm"));
    const Model bent = *moving.at(0, 2.0);
    float highest = 0.0F;
    float nearest = 10.0F; // the hand to the shoulder
    for (const glm::vec3& p : bent.meshes[0].positions) {
        highest = std::max(highest, p.y);
    }
    const glm::vec3 hand = bent.meshes[0].positions.back(); // the middle of the upper lid
    nearest = glm::length(hand);
    // Forearm and upper arm are 2 long; at 140 degrees the hand is 2 * 2 * sin(20 degrees) away.
    EXPECT_NEAR(nearest, 4.0F * std::sin(glm::radians(20.0F)), 1e-3F);
    EXPECT_LT(highest, 2.8F);
    for (const glm::vec3& normal : bent.meshes[0].normals) {
        ASSERT_NEAR(glm::length(normal), 1.0F, 1e-4F);
    }
}

TEST(MovingGltfTest, DirectionsOfAPoseGoBackToRestAsNormalsDo) {
    for (const char* name : {"arm", "hinge"}) { // a skin, and nodes
        const MovingGltf moving = opened(*animatedModel(name));
        const PosedModel posed = *moving.posedAt(0, 0.7 * moving.duration(0));
        const Model still = *moving.at(moving.animations(), 0.0);
        ASSERT_EQ(posed.toWorld.size(), still.meshes.size());
        float farthest = 0.0F;
        for (std::size_t m = 0; m < still.meshes.size(); ++m) {
            const ModelMesh& mesh = posed.model.meshes[m];
            for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
                const glm::vec3 world =
                    glm::inverseTranspose(glm::mat3(mesh.transform)) * mesh.normals[v];
                const glm::vec3 back = posed.atRest(m, v, world);
                const glm::vec3& rest = still.meshes[m].normals[v];
                ASSERT_LT(glm::distance(back, rest), 1e-4F) << name << ' ' << v;
                farthest = std::max(farthest, glm::distance(world, rest));
            }
        }
        EXPECT_GT(farthest, 0.5F) << name << " has moved";
    }
}

TEST(MovingGltfTest, ParametersAreWhatMoves) {
    const MovingGltf moving = opened(*animatedModel("bellows"));
    EXPECT_EQ(moving.parameters(0, 0.5), (std::vector<float>{0.25F}));
    EXPECT_EQ(opened(*animatedModel("arm")).parameters(0, 0.5).size(), 4U);
}

TEST(MovingGltfTest, DamagedMotionIsRefusedByName) {
    const auto refused = [](const std::string& bytes, const std::string& word) {
        const Result<MovingGltf, LoadError> moving = MovingGltf::open(bytes, "moving.glb");
        EXPECT_FALSE(moving);
        EXPECT_NE(moving.error().sentence.find(word), std::string::npos) << moving.error().sentence;
        EXPECT_TRUE(readGltf(bytes, "moving.glb")) << "at rest it is fine";
    };
    const std::string good = keyed("translation", "LINEAR", {0, 0, 0, 1, 0, 0}, "VEC3");
    refused(replaced(good, R"("node":0,"path")", R"("node":7,"path")"), "node");
    refused(replaced(good, R"("sampler":0)", R"("sampler":5)"), "sampler");
    refused(keyed("translation", "LINEAR", {0, 0, 0}, "VEC3"), "keys");
    refused(keyed("translation", "LINEAR", {0, 0, 0, 1, 0, INFINITY}, "VEC3"), "finite");
    refused(keyed("rotation", "LINEAR", {0, 0, 0, 1, 0, 0}, "VEC3"), "four numbers");
    const MovingGltf noSkin = opened(quadGlb(R"([{"mesh":0,"skin":3}])"));
    EXPECT_NE(noSkin.at(0, 0.0).error().sentence.find("skin 3"), std::string::npos);
}

} // namespace
} // namespace aolib::test
