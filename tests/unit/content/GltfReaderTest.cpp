#include "content/ModelFile.h"

#include <filesystem>
#include <fstream>
#include <limits>

#include <gtest/gtest.h>

#include "SmallGltf.h"

namespace aolib {
namespace {

using test::packGlb;
using test::quadBytes;
using test::quadGlb;
using test::quadJson;
using test::replaced;

Result<Model, LoadError> readGlb(const std::string& glb) {
    return readModel(glb, "some/quad.glb");
}

/// Expects a refusal whose sentence names the file and holds `reason`.
void expectGlbRefused(const std::string& glb, const std::string& reason) {
    const Result<Model, LoadError> model = readGlb(glb);
    ASSERT_FALSE(model.ok()) << "expected: " << reason;
    EXPECT_NE(model.error().sentence.find("quad.glb"), std::string::npos) << model.error().sentence;
    EXPECT_NE(model.error().sentence.find(reason), std::string::npos) << model.error().sentence;
    EXPECT_EQ(model.error().sentence.find('\n'), std::string::npos) << model.error().sentence;
}

std::string changedJson(const std::string& from, const std::string& to) {
    return packGlb(replaced(quadJson(), from, to), quadBytes());
}

TEST(GltfReaderTest, ReadsTrianglesNormalsAndName) {
    const Result<Model, LoadError> model = readGlb(quadGlb());
    ASSERT_TRUE(model.ok()) << model.error().sentence;
    EXPECT_EQ(model->name, "quad");
    ASSERT_EQ(model->meshes.size(), 1U);
    EXPECT_EQ(model->meshes[0].positions[2], glm::vec3(1, 1, 0));
    EXPECT_EQ(model->meshes[0].normals[3], glm::vec3(0, 0, 1));
    EXPECT_EQ(model->meshes[0].indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
}

TEST(GltfReaderTest, ReadsBaseColourAndDoubleSided) {
    const std::string json = replaced(
        quadJson(R"([{"mesh":0}])", R"(,"materials":[{"doubleSided":true,"pbrMetallicRoughness":
            {"baseColorFactor":[0.25,0.5,0.75,1]}}])"),
        R"("indices":2)", R"("indices":2,"material":0)");
    const Result<Model, LoadError> model = readGlb(packGlb(json, quadBytes()));
    ASSERT_TRUE(model.ok()) << model.error().sentence;
    EXPECT_EQ(model->meshes[0].baseColour, glm::vec4(0.25F, 0.5F, 0.75F, 1.0F));
    EXPECT_TRUE(model->meshes[0].doubleSided);
}

TEST(GltfReaderTest, ComposesTransformsDownTheTree) {
    const Result<Model, LoadError> model =
        readGlb(quadGlb(R"([{"children":[1],"translation":[10,0,0],"scale":[2,2,2]},
                         {"mesh":0,"rotation":[0,0,0.70710678,0.70710678],"translation":[0,3,0]}])"));
    ASSERT_TRUE(model.ok()) << model.error().sentence;
    const Bounds bounds = model->bounds(); // the quad turned by 90 degrees about z, then moved
    EXPECT_NEAR(bounds.min.x, 8.0F, 1e-5F);
    EXPECT_NEAR(bounds.max.x, 10.0F, 1e-5F);
    EXPECT_NEAR(bounds.min.y, 6.0F, 1e-5F);
    EXPECT_NEAR(bounds.max.y, 8.0F, 1e-5F);
}

TEST(GltfReaderTest, TakesMatricesAndInstancesOfOneMesh) {
    const Result<Model, LoadError> model = readGlb(quadGlb(R"([{"children":[1,2]},{"mesh":0},
                    {"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,5,1]}])"));
    ASSERT_TRUE(model.ok()) << model.error().sentence;
    EXPECT_EQ(model->triangleCount(), 4U);
    EXPECT_EQ(model->bounds().max.z, 5.0F);
}

TEST(GltfReaderTest, StripsAndFansKeepTheirFacing) {
    // Over the corners 0 1 2 0 2 3 a strip turns its second triangle round.
    const Result<Model, LoadError> strip =
        readGlb(changedJson(R"("indices":2)", R"("indices":2,"mode":5)"));
    ASSERT_TRUE(strip.ok()) << strip.error().sentence;
    EXPECT_EQ(strip->meshes[0].indices,
              (std::vector<std::uint32_t>{0, 1, 2, 2, 1, 0, 2, 0, 2, 2, 0, 3}));
    const Result<Model, LoadError> fan = readGlb(changedJson(R"("indices":2)", R"("mode":6)"));
    ASSERT_TRUE(fan.ok()) << fan.error().sentence;
    EXPECT_EQ(fan->meshes[0].indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
}

TEST(GltfReaderTest, SparseValuesReplaceTheVerticesTheyName) {
    const std::string json = replaced(
        quadJson(), R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})",
        R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":2,
            "indices":{"bufferView":2,"byteOffset":2,"componentType":5123},
            "values":{"bufferView":1,"byteOffset":12}}})");
    const Result<Model, LoadError> model = readGlb(packGlb(json, quadBytes()));
    ASSERT_TRUE(model.ok()) << model.error().sentence;
    EXPECT_EQ(model->meshes[0].positions,
              (std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 1, 0}}));
}

TEST(GltfReaderTest, QuantisedAndNormalisedPositionsBecomeFloats) {
    const std::string bytes =
        test::shortBytes({0, 0, 0, 0, 65535, 0, 0, 0, 0, 13107, 0, 0}) + std::string(84, '\0');
    const auto reader = [&](const std::string& accessor) {
        const std::string json = replaced(
            replaced(replaced(quadJson(), R"("NORMAL":1},"indices":2)", R"("TANGENT":1})"),
                     R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})", accessor),
            R"("byteLength":48})", R"("byteLength":48,"byteStride":8})");
        return readGlb(packGlb(json, bytes));
    };
    const Result<Model, LoadError> plain =
        reader(R"({"bufferView":0,"componentType":5123,"count":3,"type":"VEC3"})");
    ASSERT_TRUE(plain.ok()) << plain.error().sentence;
    EXPECT_EQ(plain->meshes[0].positions[1], glm::vec3(65535, 0, 0));
    const Result<Model, LoadError> scaled = reader(
        R"({"bufferView":0,"componentType":5123,"count":3,"type":"VEC3","normalized":true})");
    ASSERT_TRUE(scaled.ok()) << scaled.error().sentence;
    EXPECT_EQ(scaled->meshes[0].positions[1], glm::vec3(1, 0, 0));
    EXPECT_NEAR(scaled->meshes[0].positions[2].y, 0.2F, 1e-6F);
}

TEST(GltfReaderTest, MissingImagesDoNotMatter) {
    const std::string extra = R"(,"images":[{"uri":"gone.png"},{"bufferView":77}],
        "textures":[{"source":0}],"materials":[{"pbrMetallicRoughness":
        {"baseColorTexture":{"index":0}}}])";
    const Result<Model, LoadError> model = readGlb(quadGlb(R"([{"mesh":0}])", extra));
    EXPECT_TRUE(model.ok()) << model.error().sentence;
}

TEST(GltfReaderTest, ReadsExternalBuffers) {
    const std::filesystem::path folder = AOLIB_TEST_FOLDER;
    std::filesystem::create_directories(folder);
    const std::filesystem::path file = folder / "quad.gltf";
    const std::string uri = R"({"byteLength":108,"uri":"quad%20data.bin"})";
    std::ofstream(file) << replaced(quadJson(), R"({"byteLength":108})", uri);
    std::filesystem::remove(folder / "quad data.bin");
    const Result<Model, LoadError> missing = loadModel(file);
    ASSERT_FALSE(missing.ok());
    EXPECT_NE(missing.error().sentence.find("quad data.bin: there is no such file"),
              std::string::npos)
        << missing.error().sentence;
    std::ofstream(folder / "quad data.bin", std::ios::binary) << quadBytes();
    const Result<Model, LoadError> model = loadModel(file);
    EXPECT_TRUE(model.ok()) << model.error().sentence;
}

TEST(GltfReaderTest, RefusesGraphsThatAreNoTrees) {
    expectGlbRefused(quadGlb(R"([{"children":[1]},{"children":[0],"mesh":0}])"), "reached twice");
    expectGlbRefused(quadGlb(R"([{"children":[1,1]},{"mesh":0}])"), "reached twice");
    expectGlbRefused(quadGlb(R"([{"children":[7],"mesh":0}])"), "node 7 does not exist");
    expectGlbRefused(quadGlb(R"([{"mesh":3}])"), "names mesh 3, which does not exist");
    expectGlbRefused(changedJson(R"("scene":0)", R"("scene":4)"), "default scene 4 does not exist");
}

TEST(GltfReaderTest, RefusesTransformsThatAreNoTransforms) {
    expectGlbRefused(quadGlb(R"([{"mesh":0,"rotation":[0,0,0,0]}])"), "rotation of length zero");
    expectGlbRefused(quadGlb(R"([{"mesh":0,"scale":[1,2]}])"), "wrong number of values");
    expectGlbRefused(quadGlb(R"([{"mesh":0,"translation":[1e300,0,0]}])"), "not finite");
}

TEST(GltfReaderTest, RefusesIndicesThatNameNoVertex) {
    std::string bytes = quadBytes();
    bytes[96] = 4;
    expectGlbRefused(packGlb(quadJson(), bytes), "index 4 names none of 4 vertices");
}

TEST(GltfReaderTest, RefusesValuesThatAreNotFinite) {
    std::string bytes = quadBytes();
    const std::string infinity = test::floatBytes({std::numeric_limits<float>::infinity()});
    expectGlbRefused(packGlb(quadJson(), bytes.replace(12, 4, infinity)),
                     "the position of vertex 1 is not finite");
    bytes = quadBytes();
    const std::string nan = test::floatBytes({std::numeric_limits<float>::quiet_NaN()});
    expectGlbRefused(packGlb(quadJson(), bytes.replace(60, 4, nan)),
                     "the normal of vertex 1 is not finite");
}

TEST(GltfReaderTest, RefusesBytesOutsideTheirBuffers) {
    expectGlbRefused(changedJson(R"("count":4)", R"("count":5)"),
                     "past the end of its buffer view");
    expectGlbRefused(changedJson(R"("byteLength":48})", R"("byteLength":480})"),
                     "past the end of its buffer");
    expectGlbRefused(changedJson(R"("bufferView":0)", R"("bufferView":9)"), "buffer view 9");
    expectGlbRefused(changedJson(R"("buffer":0)", R"("buffer":3)"), "buffer 3");
    expectGlbRefused(changedJson(R"({"byteLength":108})", R"({"byteLength":1080})"),
                     "should have 1080 bytes");
    expectGlbRefused(changedJson(R"("count":4)", R"("count":18446744073709551615)"),
                     "past the end");
    expectGlbRefused(changedJson(R"("bufferView":0,"componentType":5126,"count":4)",
                                 R"("componentType":5126,"count":999999999999)"),
                     "without any bytes");
}

TEST(GltfReaderTest, RefusesDamagedContainers) {
    const std::string glb = quadGlb();
    expectGlbRefused("", "empty");
    expectGlbRefused(glb.substr(0, 10), "truncated");
    expectGlbRefused(glb.substr(0, glb.size() - 1), "truncated, the header promises");
    expectGlbRefused("not a glTF at all", "not valid JSON");
    expectGlbRefused("[1,2]", "not an object");
    expectGlbRefused(changedJson("\"asset\"", "\"basset\""), "not a usable glTF");
    expectGlbRefused(replaced(glb, "JSON", "NOSJ"), "without a JSON chunk");
    expectGlbRefused(replaced(glb, std::string("\2\0\0\0", 4), std::string("\1\0\0\0", 4)),
                     "container version 1");
}

TEST(GltfReaderTest, RefusesWhatItCannotRead) {
    expectGlbRefused(
        quadGlb(R"([{"mesh":0}])", R"(,"extensionsRequired":["KHR_draco_mesh_compression"])"),
        "KHR_draco_mesh_compression");
    expectGlbRefused(
        quadGlb(R"([{"mesh":0}])", ",\"extras\":" + std::string(500, '[') + std::string(500, ']')),
        "nests deeper");
    expectGlbRefused(changedJson(R"("indices":2)", R"("indices":2,"mode":1)"),
                     "holds no triangles");
    const Result<Model, LoadError> unknown = readModel("x", "thing.stl");
    ASSERT_FALSE(unknown.ok());
    EXPECT_NE(unknown.error().sentence.find("thing.stl: not a model file"), std::string::npos);
}

TEST(GltfReaderTest, NamesFilesThatCannotBeOpened) {
    EXPECT_NE(
        loadModel("nowhere/gone.glb").error().sentence.find("gone.glb: there is no such file"),
        std::string::npos);
    const std::filesystem::path folder = std::filesystem::path(AOLIB_TEST_FOLDER) / "folder.glb";
    std::filesystem::create_directories(folder);
    EXPECT_NE(loadModel(folder).error().sentence.find("not a regular file"), std::string::npos);
}

} // namespace
} // namespace aolib
