#include "content/ModelFile.h"

#include <gtest/gtest.h>

namespace aolib {
namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Result<Model, LoadError> readText(const std::string& text) {
    return readModel(text, "some/thing.obj");
}

void expectObjRefused(const std::string& text, const std::string& reason) {
    const Result<Model, LoadError> model = readText(text);
    ASSERT_FALSE(model.ok()) << text;
    EXPECT_NE(model.error().sentence.find("thing.obj"), std::string::npos)
        << model.error().sentence;
    EXPECT_NE(model.error().sentence.find(reason), std::string::npos) << model.error().sentence;
}

TEST(ObjReaderTest, ReadsEveryFormOfIndex) {
    for (const char* face :
         {"f 1 2 3 4", "f 1/1 2/2 3/3 4/4", "f 1//1 2//1 3//1 4//1", "f 1/5/1 2//1 3/7/1 4//1",
          "f -4 -3 -2 -1", "f -4//-1 -3//-1 3//1 4//1"}) {
        const Result<Model, LoadError> model = readText(square + "vn 0 0 2\n" + face + "\n");
        ASSERT_TRUE(model.ok()) << face << ": " << model.error().sentence;
        const ModelMesh& mesh = model->meshes[0];
        EXPECT_EQ(mesh.indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3})) << face;
        EXPECT_EQ(mesh.positions.size(), 4U) << face;
        const bool withNormals = std::string(face).find("//") != std::string::npos;
        EXPECT_EQ(mesh.normals.size(), withNormals ? 4U : 0U) << face;
        if (withNormals) {
            EXPECT_EQ(mesh.normals[0], glm::vec3(0, 0, 1));
        }
    }
}

TEST(ObjReaderTest, PolygonsBecomeFans) {
    const Result<Model, LoadError> model = readText(square + "v 0.5 2 0\nf 1 2 3 5 4\n");
    ASSERT_TRUE(model.ok()) << model.error().sentence;
    EXPECT_EQ(model->triangleCount(), 3U);
}

TEST(ObjReaderTest, SkipsWhatItDoesNotUse) {
    const Result<Model, LoadError> model =
        readText("# a comment\r\nmtllib x.mtl\r\no thing\r\nv 0 0 0 1 0.5 0.5\r\nv +1 0 0\r\n"
                 "v 1e0 1.5 -0\r\nvt 0 0\r\ng part\r\nusemtl red\r\ns off\r\nl 1 2\r\np 1\r\n"
                 "f 1 2 \\\r\n3 # the end");
    ASSERT_TRUE(model.ok()) << model.error().sentence;
    EXPECT_EQ(model->triangleCount(), 1U);
    EXPECT_EQ(model->meshes[0].positions[2], glm::vec3(1.0F, 1.5F, 0.0F));
}

TEST(ObjReaderTest, DropsNormalsThatSomeCornersLack) {
    const Result<Model, LoadError> model =
        readText(square + "vn 0 0 1\nf 1//1 2//1 3//1\nf 1 3 4\n");
    ASSERT_TRUE(model.ok()) << model.error().sentence;
    EXPECT_TRUE(model->meshes[0].normals.empty());
    EXPECT_EQ(model->meshes[0].positions.size(), 4U);
}

TEST(ObjReaderTest, NamesTheLineOfWhatIsWrong) {
    expectObjRefused("v 0 0 0\nv 1 x 0\n", "line 2: 'x' is not a finite number");
    expectObjRefused("v 0 0 nan\n", "line 1: 'nan' is not a finite number");
    expectObjRefused("v 0 0 inf\n", "line 1: 'inf'");
    expectObjRefused("v 0 1e99 0\n", "line 1: '1e99'");
    expectObjRefused("v 0 0\n", "line 1: 'v' needs three numbers");
    expectObjRefused(square + "f 1 2\n", "line 5: a face needs at least three corners");
    expectObjRefused(square + "f 1 2 5\n", "line 5: index 5 names none of 4 positions");
    expectObjRefused(square + "f 1 2 0\n", "line 5: '0' is not a corner");
    expectObjRefused(square + "f 1 2 -5\n", "line 5: '-5' is not a corner");
    expectObjRefused(square + "f 1 2 3x\n", "line 5: '3x' is not a corner");
    expectObjRefused(square + "f 1//1 2//1 3//1\n", "line 5: index 1 names none of 0 normals");
    expectObjRefused(square + "f 1// 2// 3//\n", "is not a corner");
    expectObjRefused(square, "holds no triangles");
    expectObjRefused("", "empty");
}

} // namespace
} // namespace aolib
