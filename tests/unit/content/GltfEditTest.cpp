#include "content/GltfEdit.h"

#include <cstring>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "SmallGltf.h"
#include "content/GltfBuild.h"
#include "content/GltfReader.h"

namespace aolib::test {
namespace {

using Json = nlohmann::json;

const char* const kTwoNodes = R"([{"children":[1,2]},{"mesh":0},{"mesh":0}])";
const char* const kExtra = R"(,"materials":[{"name":"paint","pbrMetallicRoughness":
    {"baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"offset":[1,2]}}}},
    "extras":{"mine":7}}],
    "textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,AAAA"}],
    "extensionsUsed":["KHR_texture_transform","VENDOR_unknown"],
    "extensions":{"VENDOR_unknown":{"deep":[1,{"er":null}]}},"animations":[],"extras":"kept")";

GltfEdit editOf(const std::string& bytes, const std::filesystem::path& file = "quad.glb") {
    const Result<GltfParts, LoadError> parts = openGltf(bytes, file);
    EXPECT_TRUE(parts.ok()) << parts.error().sentence;
    Result<GltfEdit, LoadError> edit = GltfEdit::open(*parts, file.parent_path());
    EXPECT_TRUE(edit.ok()) << edit.error().sentence;
    return std::move(*edit);
}

/// A GLB taken apart by other means than those under test.
struct Opened {
    Json json;
    std::string binary;

    explicit Opened(const GltfEdit& edit) {
        const Result<std::string, LoadError> glb = edit.glb();
        EXPECT_TRUE(glb.ok()) << glb.error().sentence;
        std::uint32_t length = 0;
        std::memcpy(&length, &(*glb)[12], 4);
        json = Json::parse(glb->substr(20, length));
        binary = glb->substr(28 + length);
        EXPECT_EQ(glb->size() % 4, 0U);
        EXPECT_TRUE(readGltf(*glb, "again.glb").ok());
    }
    std::string view(std::size_t number) const {
        const Json& found = json["bufferViews"][number];
        return binary.substr(found.value("byteOffset", std::size_t{0}),
                             found["byteLength"].get<std::size_t>());
    }
    std::vector<float> floats(std::size_t accessor) const {
        const std::string bytes = view(json["accessors"][accessor]["bufferView"]);
        std::vector<float> values(bytes.size() / 4);
        std::memcpy(values.data(), bytes.data(), bytes.size());
        return values;
    }
};

TEST(GltfEditTest, WhatIsNotTouchedStays) {
    const std::string source = quadGlb(kTwoNodes, kExtra);
    const Opened after(editOf(source));
    const Json before = Json::parse(quadJson(kTwoNodes, kExtra));
    EXPECT_EQ(after.json, before);
    EXPECT_EQ(after.binary.substr(0, 108), quadBytes());
}

TEST(GltfEditTest, AnOcclusionTextureIsAllThatAMaterialGets) {
    GltfEdit edit = editOf(quadGlb(kTwoNodes, kExtra));
    EXPECT_EQ(edit.materialName(0), "paint");
    EXPECT_EQ(edit.occlusionUvSet(0), -1);
    const std::vector<std::uint8_t> png{1, 2, 3, 4, 5};
    edit.setOcclusionTexture(0, png, 1, "shade");
    EXPECT_EQ(edit.occlusionUvSet(0), 1);
    const Opened after(edit);
    Json material = after.json["materials"][0];
    const Json occlusion = material["occlusionTexture"];
    material.erase("occlusionTexture");
    EXPECT_EQ(material, Json::parse(quadJson(kTwoNodes, kExtra))["materials"][0]);
    EXPECT_EQ(occlusion["texCoord"], 1);
    const Json& texture = after.json["textures"][occlusion["index"].get<std::size_t>()];
    EXPECT_EQ(after.json["samplers"][texture["sampler"].get<std::size_t>()]["minFilter"], 9987);
    const Json& image = after.json["images"][texture["source"].get<std::size_t>()];
    EXPECT_EQ(image["mimeType"], "image/png");
    EXPECT_EQ(after.view(image["bufferView"]), std::string("\1\2\3\4\5"));
}

TEST(GltfEditTest, NodesGetMeshesOfTheirOwnWhenTheyShareOne) {
    GltfEdit edit = editOf(quadGlb(kTwoNodes, kExtra));
    EXPECT_EQ(edit.ownMesh(1), 1);
    EXPECT_EQ(edit.ownMesh(1), 1);
    EXPECT_EQ(edit.ownMesh(2), 0);
    edit.setAttribute(1, 0, "_AO", edit.addFloats({0.5F, 0.25F, 1.0F, 0.0F}, 1));
    const Opened after(edit);
    ASSERT_EQ(after.json["meshes"].size(), 2U);
    EXPECT_FALSE(after.json["meshes"][0]["primitives"][0]["attributes"].contains("_AO"));
    const Json& attributes = after.json["meshes"][1]["primitives"][0]["attributes"];
    EXPECT_EQ(after.floats(attributes["_AO"]), (std::vector<float>{0.5F, 0.25F, 1.0F, 0.0F}));
    EXPECT_EQ(after.json["accessors"][attributes["_AO"].get<std::size_t>()]["count"], 4);
}

TEST(GltfEditTest, VerticesAreSplitWithAllTheirAttributes) {
    std::string json = replaced(quadJson(), R"("count":4,"type":"VEC3"})",
                                R"("count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]})");
    GltfEdit edit = editOf(packGlb(json, quadBytes()));
    ASSERT_FALSE(edit.splitVertices(0, 0, {2, 2, 1}, {0, 1, 2}));
    const Opened after(edit);
    const Json& primitive = after.json["meshes"][0]["primitives"][0];
    const auto positions = primitive["attributes"]["POSITION"].get<std::size_t>();
    EXPECT_EQ(after.floats(positions), (std::vector<float>{1, 1, 0, 1, 1, 0, 1, 0, 0}));
    EXPECT_EQ(after.json["accessors"][positions]["min"], Json({1, 0, 0}));
    EXPECT_EQ(after.json["accessors"][positions]["max"], Json({1, 1, 0}));
    EXPECT_EQ(after.floats(primitive["attributes"]["NORMAL"]),
              (std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}));
    EXPECT_EQ(after.json["accessors"][primitive["indices"].get<std::size_t>()]["count"], 3);
}

TEST(GltfEditTest, SparseVerticesAreRefused) {
    const std::string json =
        replaced(quadJson(), R"("count":4,"type":"VEC3"})",
                 R"("count":4,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":2,
                    "componentType":5123},"values":{"bufferView":0}}})");
    GltfEdit edit = editOf(packGlb(json, quadBytes()));
    const auto error = edit.splitVertices(0, 0, {0, 1, 2}, {0, 1, 2});
    ASSERT_TRUE(error);
    EXPECT_NE(error->sentence.find("sparse"), std::string::npos);
}

TEST(GltfEditTest, ImagesInFilesArePackedIn) {
    const std::filesystem::path folder = std::filesystem::path(AOLIB_TEST_FOLDER) / "GltfEdit";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "a b.png", std::ios::binary) << "\x89PNG and so on";
    const std::string extra = R"(,"images":[{"uri":"a%20b.png"}])";
    const Opened after(editOf(quadGlb(R"([{"mesh":0}])", extra), folder / "quad.gltf"));
    const Json& image = after.json["images"][0];
    EXPECT_FALSE(image.contains("uri"));
    EXPECT_EQ(image["mimeType"], "image/png");
    EXPECT_EQ(after.view(image["bufferView"]), "\x89PNG and so on");
    std::filesystem::remove_all(folder);
    const Result<GltfParts, LoadError> parts =
        openGltf(quadGlb(R"([{"mesh":0}])", extra), "quad.gltf");
    ASSERT_TRUE(parts.ok());
    EXPECT_NE(GltfEdit::open(*parts, folder).error().sentence.find("a b.png"), std::string::npos);
}

TEST(GltfEditTest, GeneratedShapesAndModelsBecomeGltf) {
    const UvMesh shape = uvShape("uv-box");
    Result<GltfEdit, LoadError> edit = GltfEdit::open(gltfOf(shape, "uv-box"), {});
    ASSERT_TRUE(edit.ok()) << edit.error().sentence;
    EXPECT_EQ(edit->uvSets(0, 0), 1);
    const Result<Model, LoadError> read = readGltf(*edit->glb(), "box.glb");
    ASSERT_TRUE(read.ok()) << read.error().sentence;
    EXPECT_EQ(read->meshes[0].positions, shape.positions);
    EXPECT_EQ(read->meshes[0].indices, shape.indices);
    EXPECT_EQ(read->meshes[0].origin.material, 0);
    const Opened opened(*edit);
    const std::vector<float> uvs = opened.floats(2);
    EXPECT_EQ(uvs[1], 1.0F - shape.uvs[0].y) << "glTF counts v from the top";
}

} // namespace
} // namespace aolib::test
