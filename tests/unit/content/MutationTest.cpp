/// Damaged files are read or refused, and never harm: run under the sanitizers too.
#include "content/ModelFile.h"

#include <cmath>

#include <gtest/gtest.h>

#include "SmallGltf.h"
#include "content/generated/Pcg.h"

namespace aolib {
namespace {

/// A model that was accepted must be usable; a refusal must be one sentence with the file's name.
void expectSound(const Result<Model, LoadError>& model, const std::string& name) {
    if (!model) {
        EXPECT_NE(model.error().sentence.find(name), std::string::npos) << model.error().sentence;
        EXPECT_GT(model.error().sentence.size(), name.size() + 4);
        return;
    }
    EXPECT_GT(model->triangleCount(), 0U);
    for (const ModelMesh& mesh : model->meshes) {
        EXPECT_TRUE(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size());
        EXPECT_EQ(mesh.indices.size() % 3, 0U);
        for (const std::uint32_t index : mesh.indices) {
            ASSERT_LT(index, mesh.positions.size());
        }
    }
    const TriangleMesh flat = model->flattened();
    for (const glm::vec3& p : flat.positions) {
        ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    }
}

/// Reads every truncation and `flips` copies in which a few bytes were changed.
void mutate(const std::string& bytes, const std::string& name, int flips) {
    ASSERT_TRUE(readModel(bytes, name).ok()) << readModel(bytes, name).error().sentence;
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        expectSound(readModel(bytes.substr(0, length), name), name);
    }
    Pcg random(0xA0);
    for (int i = 0; i < flips; ++i) {
        std::string damaged = bytes;
        for (int k = 1 + random.pick(4); k > 0; --k) {
            const auto at = static_cast<std::size_t>(random.pick(static_cast<int>(bytes.size())));
            // Half of the changes put one digit or bracket for another, which survives the parser.
            damaged[at] = random.pick(2) == 0 ? static_cast<char>(random.pick(256))
                                              : "0123456789-[]{},:\"eE."[random.pick(21)];
        }
        expectSound(readModel(damaged, name), name);
    }
}

const std::string twoNodes =
    R"([{"children":[1],"scale":[2,2,-2]},{"mesh":0,"rotation":[0,0,0.6,0.8]}])";

TEST(MutationTest, Glb) {
    mutate(test::quadGlb(twoNodes), "small.glb", 3000);
}

TEST(MutationTest, SparseGlb) {
    const std::string sparse = test::replaced(
        test::quadJson(twoNodes),
        R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})",
        R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":2,
            "indices":{"bufferView":2,"componentType":5123},
            "values":{"bufferView":1,"byteOffset":12}}})");
    mutate(test::packGlb(sparse, test::quadBytes()), "sparse.glb", 3000);
}

TEST(MutationTest, Gltf) {
    // Three positions as base64: (0,0,0) (1,0,0) (0,1,0).
    const std::string text =
        R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5}]}],
        "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)"
        "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"
        R"("}],"bufferViews":[{"buffer":0,"byteLength":36,"byteStride":12}],
        "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}]})";
    mutate(text, "small.gltf", 3000);
}

TEST(MutationTest, Obj) {
    mutate("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nvn 0 0 1\nf 1//1 2//1 3//1 4//1\nf -1 -2 -3\n",
           "small.obj", 3000);
}

} // namespace
} // namespace aolib
