/// Real files made to trip loaders. They are looked for in AOLIB_MODELS_DIR/stress.
#include <filesystem>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "content/ModelFile.h"
#include "content/SceneSource.h"

namespace aolib {
namespace {

struct Expected {
    const char* file;
    std::size_t triangles; ///< drawn: instances count each time
};

/// Where the stress models are, or an empty path.
std::filesystem::path stressFolder() {
    const std::optional<std::filesystem::path> models = defaultModelsDir();
    return models && std::filesystem::is_directory(*models / "stress") ? *models / "stress"
                                                                       : std::filesystem::path();
}

class StressModelsTest : public testing::TestWithParam<Expected> {};

TEST_P(StressModelsTest, HasEveryTriangle) {
    const std::filesystem::path folder = stressFolder();
    if (folder.empty()) {
        GTEST_SKIP() << "NOT TESTED: no stress models; set AOLIB_MODELS_DIR to the folder that "
                        "holds stress/";
    }
    const Result<Model, LoadError> model = loadModel(folder / GetParam().file);
    ASSERT_TRUE(model.ok()) << model.error().sentence;
    EXPECT_EQ(model->triangleCount(), GetParam().triangles);
    EXPECT_EQ(model->flattened().triangleCount(), GetParam().triangles);
}

INSTANTIATE_TEST_SUITE_P(
    Files, StressModelsTest,
    // NegativeScaleTest stores 3884 triangles; three spheres of 1280 are drawn twice.
    testing::Values(Expected{"NegativeScaleTest.glb", 3884 + 3 * 1280},
                    Expected{"OrientationTest.glb", 524}, Expected{"BoxInterleaved.glb", 12},
                    Expected{"SimpleSparseAccessor.gltf", 12},
                    Expected{"MeshPrimitiveModes.gltf", 16},
                    Expected{"TriangleWithoutIndices.gltf", 1}),
    [](const auto& file) { return std::filesystem::path(file.param.file).stem().string(); });

TEST(StressModels, RefusesInfinitePositions) {
    const std::filesystem::path folder = stressFolder();
    if (folder.empty()) {
        GTEST_SKIP() << "NOT TESTED: no stress models in AOLIB_MODELS_DIR/stress";
    }
    const Result<Model, LoadError> model = loadModel(folder / "BoxWithInfinites.glb");
    ASSERT_FALSE(model.ok());
    EXPECT_NE(model.error().sentence.find("BoxWithInfinites.glb"), std::string::npos);
    EXPECT_NE(model.error().sentence.find("not finite"), std::string::npos)
        << model.error().sentence;
}

TEST(StressModels, SparseValuesReplaceTheirVertices) {
    const std::filesystem::path folder = stressFolder();
    if (folder.empty()) {
        GTEST_SKIP() << "NOT TESTED: no stress models in AOLIB_MODELS_DIR/stress";
    }
    const Result<Model, LoadError> model = loadModel(folder / "SimpleSparseAccessor.gltf");
    ASSERT_TRUE(model.ok()) << model.error().sentence;
    EXPECT_EQ(model->bounds().max, glm::vec3(6, 4, 0)); // 2 without the sparse values
}

TEST(StressModels, MirroredFacesAgreeWithTheirNormals) {
    const std::filesystem::path folder = stressFolder();
    if (folder.empty()) {
        GTEST_SKIP() << "NOT TESTED: no stress models in AOLIB_MODELS_DIR/stress";
    }
    const Result<Model, LoadError> model = loadModel(folder / "NegativeScaleTest.glb");
    ASSERT_TRUE(model.ok()) << model.error().sentence;
    const TriangleMesh flat = model->flattened();
    std::size_t contrary = 0;
    for (std::size_t i = 0; i < flat.indices.size(); i += 3) {
        const glm::vec3& a = flat.positions[flat.indices[i]];
        const glm::vec3 face = glm::cross(flat.positions[flat.indices[i + 1]] - a,
                                          flat.positions[flat.indices[i + 2]] - a);
        contrary += glm::dot(face, flat.normals[flat.indices[i]]) < 0.0F ? 1 : 0;
    }
    EXPECT_EQ(contrary, 0U);
}

} // namespace
} // namespace aolib
