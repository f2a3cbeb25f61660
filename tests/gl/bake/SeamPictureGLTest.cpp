#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <aolib/bake/Atlas.h>

#include "BakeScenes.h"
#include "GLTest.h"
#include "gl/GLSLShader.h"
#include "gl/RenderToTexture2D.h"
#include "gl/VertexArray.h"

namespace aolib::bake::test {

namespace {

// A convex body above an endless ground: what a point sees of the sky is told by its normal alone,
// W = (1 + n_y) / 2, however far it is from the ground.
constexpr const char* vertexStage = R"(#version 330 core
layout(location = 0) in vec3 aPosition;
layout(location = 1) in vec3 aPlace; // u, v, chart
layout(location = 2) in float aUp;   // the normal's part upwards
uniform mat4 uView;
out vec2 vUv;
out float vUp;
flat out float vChart;
void main() {
    vUv = aPlace.xy;
    vChart = aPlace.z;
    vUp = aUp;
    gl_Position = uView * vec4(aPosition, 1.0);
})";
constexpr const char* fragmentStage = R"(#version 330 core
uniform sampler2D uMap;
in vec2 vUv;
in float vUp;
flat in float vChart;
layout(location = 0) out vec4 oPixel;
void main() {
    oPixel = vec4(texture(uMap, vUv).r, 0.5 + 0.5 * vUp, vUv.x, vChart);
})";

/// RMSE of pictures of a baked body, beside borders of charts and elsewhere.
struct PictureErrors {
    double border = 0.0;
    double inside = 0.0;
    double worst = 0.0; ///< at borders
    int borderPixels = 0;
};

class SeamPictureGLTest : public GLTest {
protected:
    static constexpr int side = 192;

    void SetUp() override {
        GLTest::SetUp();
        if (IsSkipped()) {
            return;
        }
        generateMipmap_ =
            reinterpret_cast<void (*)(GLenum)>(reinterpret_cast<void*>(loader("glGenerateMipmap")));
        ASSERT_NE(generateMipmap_, nullptr);
    }

    /// @param zoom  the body's size in the picture, 1 fills it.
    PictureErrors errorsOf(const UvMesh& mesh, const BakedMap& map, float zoom) const;

    static BakedMap baked(const UvMesh& mesh, bool filled) {
        BakeScene scene = sceneOf(mesh);
        scene.ground = -1.5F;
        RayOptions options;
        options.rays = 256;
        auto baker = createRayBaker(scene, options);
        EXPECT_TRUE(baker.ok());
        return onlyMap(**baker, 128, filled ? MapOptions().padding : 0, filled);
    }

private:
    GLuint texture(const BakedMap& map) const;
    std::vector<glm::vec4> drawn(const UvMesh& mesh, GLuint map, const glm::mat4& view) const;

    void (*generateMipmap_)(GLenum) = nullptr;
};

/// The axis that a normal is nearest to, and its sign: each side of a box is a chart.
float chartOf(const UvMesh& mesh, std::size_t vertex) {
    const glm::vec3 n = mesh.normals[vertex];
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(n[axis]) > 0.999F) {
            return float(2 * axis + (n[axis] > 0.0F ? 1 : 0));
        }
    }
    return 6.0F;
}

GLuint SeamPictureGLTest::texture(const BakedMap& map) const {
    GLuint name = 0;
    gl.GenTextures(1, &name);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    std::vector<float> values = map.visibility;
    std::replace_if(
        values.begin(), values.end(), [](float w) { return w < 0.0F; }, 0.0F);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R32F, map.width, map.height, 0, GL_RED, GL_FLOAT,
                  values.data());
    generateMipmap_(GL_TEXTURE_2D);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return name;
}

std::vector<glm::vec4> SeamPictureGLTest::drawn(const UvMesh& mesh, GLuint map,
                                                const glm::mat4& view) const {
    std::vector<glm::vec3> places;
    std::vector<float> ups;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        places.emplace_back(mesh.uvs[i], chartOf(mesh, i));
        ups.push_back(mesh.normals[i].y);
    }
    auto body = gl::VertexArray::createTriangles(gl, {mesh.positions, places, ups, mesh.indices},
                                                 "test/body");
    auto shader = gl::GLSLShader::build(gl, {"vertex", vertexStage}, {"fragment", fragmentStage});
    gl::RenderToTexture2D::Settings settings;
    settings.width = settings.height = side;
    settings.targets = {gl::RenderToTexture2D::Format::RGBA32F};
    settings.depth = gl::RenderToTexture2D::Depth::Depth32F;
    auto target = gl::RenderToTexture2D::create(gl, settings);
    EXPECT_TRUE(body.ok() && shader.ok() && target.ok());
    target->bindAllAsTargets();
    const std::array<float, 4> nothing{-1.0F, -1.0F, -1.0F, -1.0F};
    const float farthest = 1.0F;
    gl.ClearBufferfv(GL_COLOR, 0, nothing.data());
    gl.ClearBufferfv(GL_DEPTH, 0, &farthest);
    gl.Enable(GL_DEPTH_TEST);
    gl.BindTexture(GL_TEXTURE_2D, map);
    shader->bind();
    shader->set("uView", view);
    shader->set("uMap", 0);
    body->drawTriangles();
    gl.Disable(GL_DEPTH_TEST);
    std::vector<glm::vec4> pixels(std::size_t{side} * side);
    target->bindForReading(0);
    gl.ReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, pixels.data());
    return pixels;
}

PictureErrors SeamPictureGLTest::errorsOf(const UvMesh& mesh, const BakedMap& map,
                                          float zoom) const {
    const GLuint name = texture(map);
    PictureErrors errors;
    int insidePixels = 0;
    for (const glm::vec3 eye : {glm::vec3(1.0F, 0.6F, 0.3F), glm::vec3(1.0F, -0.5F, -0.4F)}) {
        glm::mat4 view = glm::lookAt(eye, glm::vec3(0.0F), glm::vec3(0.0F, 1.0F, 0.0F));
        const float reach = 2.0F / zoom;
        view = glm::ortho(-reach, reach, -reach, reach, -9.0F, 9.0F) * view;
        const std::vector<glm::vec4> pixels = drawn(mesh, name, view);
        for (int y = 1; y < side - 1; ++y) {
            for (int x = 1; x < side - 1; ++x) {
                const auto i = static_cast<std::size_t>(y * side + x);
                const glm::vec4& pixel = pixels[i];
                if (pixel.w < 0.0F) {
                    continue;
                }
                bool border = false;
                for (const std::size_t j : {i - 1, i + 1, i - side, i + side}) {
                    const glm::vec4& other = pixels[j];
                    border = border || (other.w >= 0.0F &&
                                        (other.w != pixel.w || std::abs(other.z - pixel.z) > 0.5F));
                }
                const double error = double(pixel.x) - double(pixel.y);
                (border ? errors.border : errors.inside) += error * error;
                ++(border ? errors.borderPixels : insidePixels);
                errors.worst = border ? std::max(errors.worst, std::abs(error)) : errors.worst;
            }
        }
    }
    gl.DeleteTextures(1, &name);
    errors.border = std::sqrt(errors.border / std::max(1, errors.borderPixels));
    errors.inside = std::sqrt(errors.inside / std::max(1, insidePixels));
    return errors;
}

/// A distance to look from, and what borders may have there: texels per pixel grow from 0.7 to 20.
struct Distance {
    float zoom;
    double aboveInside; ///< RMSE at borders less that elsewhere, which is the rays' noise
};

class SeamPictureOfBodiesGLTest : public SeamPictureGLTest {
protected:
    void expectNoBorder(const UvMesh& mesh, const std::vector<Distance>& distances) const {
        const BakedMap map = baked(mesh, true);
        const BakedMap bare = baked(mesh, false);
        for (const Distance& distance : distances) {
            const PictureErrors errors = errorsOf(mesh, map, distance.zoom);
            const PictureErrors without = errorsOf(mesh, bare, distance.zoom);
            EXPECT_GT(errors.borderPixels, distance.zoom > 0.15F ? 50 : 10);
            EXPECT_LT(errors.border, errors.inside + distance.aboveInside) << distance.zoom;
            EXPECT_GT(without.border, 3.0 * errors.border)
                << "without padding and filling a border shows, at " << distance.zoom;
        }
    }
};

TEST_P(SeamPictureOfBodiesGLTest, ASpheresMeridianDoesNotShowFromAnyDistance) {
    UvMesh ball;
    addUvSphere(ball, glm::vec3(0.0F), 1.0F, 64, 32, {{0.1F, 0.1F}, {0.9F, 0.9F}});
    expectNoBorder(ball, {{1.5F, 0.003},
                          {0.75F, 0.003},
                          {0.375F, 0.004},
                          {0.19F, 0.004},
                          {0.095F, 0.001},
                          {0.05F, 0.004}});
}

TEST_P(SeamPictureOfBodiesGLTest, ABoxsEdgesDoNotShowFromAnyDistance) {
    // Sides from black to white lie beside each other in the map. From the last distance a side is
    // four pixels wide, and where they end the picture itself is made of mixtures.
    expectNoBorder(uvShape("uv-box"), {{1.5F, 0.0005},
                                       {0.75F, 0.0005},
                                       {0.375F, 0.0005},
                                       {0.19F, 0.001},
                                       {0.095F, 0.005},
                                       {0.05F, 0.01}});
}

TEST_P(SeamPictureOfBodiesGLTest, ChartsOfAnAtlasDoNotShowWherePixelsAreAsWideAsItsGaps) {
    UvMesh box;
    addUvBox(box, glm::vec3(-1.0F), glm::vec3(1.0F, 0.7F, 1.3F), 4);
    const Surface surface = surfaceOf(box);
    const auto unwrapped = [&](int gap) {
        const auto atlas = makeAtlas({&surface}, 128, 128, gap);
        EXPECT_TRUE(atlas.ok()) << atlas.status().message();
        const Surface after = withAtlas(surface, atlas->surfaces[0]);
        return UvMesh{after.positions, after.normals, after.uvs, after.indices};
    };
    // What `aolib bake` takes, and what a host takes that will look from afar.
    expectNoBorder(unwrapped(8),
                   {{1.5F, 0.0005}, {0.75F, 0.0005}, {0.375F, 0.0005}, {0.19F, 0.002}});
    expectNoBorder(unwrapped(16), {{1.5F, 0.0005},
                                   {0.75F, 0.0005},
                                   {0.375F, 0.0005},
                                   {0.19F, 0.0005},
                                   {0.095F, 0.0005},
                                   {0.05F, 0.003}});
}

INSTANTIATE_TEST_SUITE_P(One, SeamPictureOfBodiesGLTest, testing::Values(testContexts().front()),
                         nameOf);

} // namespace

} // namespace aolib::bake::test
