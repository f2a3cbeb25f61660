#include <array>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include <aolib/lighting/EnvironmentLight.h>

#include "GLTest.h"
#include "content/generated/Environments.h"
#include "gl/GLSLShader.h"
#include "gl/RenderToTexture2D.h"
#include "gl/VertexArray.h"

namespace aolib::lighting {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 32;
constexpr ConeTableOptions kCones{.columns = 32, .rows = 17, .apertures = 7};

constexpr const char* kVertex = R"(#version 330 core
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";

/// The functions of environmentShader() against those of the library on the CPU. A pixel's place
/// is that of a direction on a map.
class EnvironmentLightGLTest : public GLTest {
protected:
    void SetUp() override {
        GLTest::SetUp();
        if (IsSkipped()) {
            return;
        }
        gl::RenderToTexture2D::Settings settings;
        settings.width = kWidth;
        settings.height = kHeight;
        settings.targets = {gl::RenderToTexture2D::Format::RGBA32F};
        settings.label = "test";
        target_ = std::move(*gl::RenderToTexture2D::create(gl, settings));
        map_ = smallStudio();
        Result<EnvironmentLight> light = EnvironmentLight::create(
            loader, map_, {.cones = kCones, .sectors = true, .angles = true});
        ASSERT_TRUE(light) << light.status().message();
        light_.emplace(std::move(*light));
    }
    void TearDown() override {
        light_.reset();
        target_ = {};
        GLTest::TearDown();
    }

    /// What an expression of the shader is, for `direction` of each pixel.
    std::vector<glm::vec4> shaded(const std::string& expression) {
        const std::string text = "#version 330 core\n" + std::string(environmentShader()) + R"(
uniform sampler2DArray cones;
uniform sampler2DArray sectors;
uniform sampler2D map;
uniform samplerCube angles;
layout(location = 0) out vec4 result;
void main() {
    vec2 place = gl_FragCoord.xy / vec2(64.0, 32.0);
    vec3 direction = latLongDirectionAt(place);
    result = vec4()" + expression +
                                 ");\n}\n";
        Result<gl::GLSLShader> shader =
            gl::GLSLShader::build(gl, {"test.vert", kVertex}, {"test.frag", text});
        EXPECT_TRUE(shader) << shader.status().message();
        const Result<gl::VertexArray> none = gl::VertexArray::createEmpty(gl, "test");
        shader->bind();
        bind(0, GL_TEXTURE_2D_ARRAY, light_->cones());
        bind(1, GL_TEXTURE_2D, light_->map());
        bind(2, GL_TEXTURE_CUBE_MAP, light_->angles());
        bind(3, GL_TEXTURE_2D_ARRAY, light_->sectors());
        shader->set("sectors", 3);
        shader->set("cones", 0);
        shader->set("map", 1);
        shader->set("angles", 2);
        target_.bindAsTarget(0);
        none->drawFullscreen();
        std::vector<glm::vec4> pixels(std::size_t{kWidth} * kHeight);
        target_.bindForReading(0);
        gl.ReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_FLOAT, pixels.data());
        return pixels;
    }
    void bind(int unit, GLenum target, TextureName name) const {
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        gl.BindTexture(target, static_cast<GLuint>(name));
    }
    static EnvironmentMap smallStudio();
    static glm::vec3 directionOf(std::size_t pixel) {
        return latLongDirection({(float(pixel % kWidth) + 0.5F) / float(kWidth),
                                 (float(pixel / kWidth) + 0.5F) / float(kHeight)});
    }

    gl::RenderToTexture2D target_;
    EnvironmentMap map_;
    std::optional<EnvironmentLight> light_;
};

/// A sixteenth of the generated studio's texels.
EnvironmentMap EnvironmentLightGLTest::smallStudio() {
    const EnvironmentMap whole = findGeneratedEnvironment("studio")->build();
    EnvironmentMap map{whole.width / 4, whole.height / 4, {}};
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            map.radiance.push_back(
                whole.radiance[std::size_t(4 * y) * std::size_t(whole.width) + std::size_t(4 * x)]);
        }
    }
    return map;
}

TEST_P(EnvironmentLightGLTest, ConesAreThoseOfTheTable) {
    // Differences: 16 bit floats, and what filters round their weights to.
    const Result<ConeTable> table = ConeTable::create(map_, kCones);
    for (const float w : {0.05F, 0.3F, 0.61F, 1.0F}) {
        const auto pixels =
            shaded("aoConeLight(cones, normalize(direction + vec3(0.3, 0.2, -0.1)), "
                   "direction, " +
                   std::to_string(w) + "), 1.0");
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const glm::vec3 direction = directionOf(i);
            const glm::vec3 normal = glm::normalize(direction + glm::vec3(0.3F, 0.2F, -0.1F));
            const glm::vec3 expected = coneLight(*table, normal, direction, w);
            ASSERT_LT(glm::distance(glm::vec3(pixels[i]), expected), 0.02F) << i << ' ' << w;
        }
    }
}

TEST_P(EnvironmentLightGLTest, SectorsAreThoseOfTheTable) {
    const Result<SectorTable> table = SectorTable::create(map_);
    ASSERT_TRUE(table.ok());
    OpenSectors open;
    std::string list;
    for (std::size_t k = 0; k < open.size(); ++k) {
        open[k] = k % 3 == 0 ? 0.0F : float(k) / 20.0F; // the last are cut
        list += (k == 0 ? "" : k % 4 == 0 ? "), vec4(" : ", ") + std::to_string(open[k]);
    }
    const auto pixels =
        shaded("aoSectorLight(sectors, direction, vec4[6](vec4(" + list + "))), 1.0");
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const glm::vec3 expected = sectorLight(*table, directionOf(i), open);
        ASSERT_LT(glm::distance(glm::vec3(pixels[i]), expected), 0.02F) << i;
    }
}

TEST_P(EnvironmentLightGLTest, IrradianceIsTheWidestCone) {
    const Result<ConeTable> table = ConeTable::create(map_, kCones);
    const auto pixels = shaded("aoIrradianceLight(cones, direction, 0.5), 1.0");
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const glm::vec3 expected = 0.5F * table->lookup(directionOf(i), 1.0F);
        ASSERT_LT(glm::distance(glm::vec3(pixels[i]), expected), 0.01F) << i;
    }
}

TEST_P(EnvironmentLightGLTest, AFullyOpenBlurIsTheMeanOfTheWholeMap) {
    // By steradians, as each step of the mipmaps averages.
    glm::dvec3 sum(0.0);
    for (int y = 0; y < map_.height; ++y) {
        const double weight = std::sin(3.14159265 * (double(y + 1) / map_.height - 0.5)) -
                              std::sin(3.14159265 * (double(y) / map_.height - 0.5));
        for (int x = 0; x < map_.width; ++x) {
            sum += weight * glm::dvec3(map_.radiance[std::size_t(y * map_.width + x)]);
        }
    }
    const glm::vec3 mean(sum / (2.0 * map_.width));
    for (const glm::vec4& pixel : shaded("aoBlurredLight(map, direction, 1.0), 1.0")) {
        ASSERT_LT(glm::distance(glm::vec3(pixel), mean), 0.01F);
    }
}

TEST_P(EnvironmentLightGLTest, AnglesFromTheCubeMapAreThoseOfTheArcTangent) {
    // 8 bits: half of 1 / 255, and half a texel of 90 / 256 degrees.
    const auto pixels = shaded("latLongPlace(direction), texture(angles, direction).rg");
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const glm::vec2 place = latLong(directionOf(i));
        ASSERT_NEAR(pixels[i].x, place.x, 1e-5F) << i;
        ASSERT_NEAR(pixels[i].y, place.y, 1e-5F) << i;
        const float level = std::cos(3.14159F * (place.y - 0.5F));
        ASSERT_NEAR(pixels[i].z, place.x, 0.002F + 0.001F / level) << i;
        ASSERT_NEAR(pixels[i].w, place.y, 0.004F) << i;
    }
}

TEST_P(EnvironmentLightGLTest, WhatInterpolationPutsOutsideIsCut) {
    for (const glm::vec4& pixel : shaded("aoConeLight(cones, direction, direction, -0.1).r, "
                                         "aoBlurredLight(map, direction, -0.1).r, "
                                         "aoIrradianceLight(cones, direction, 1.5).r - "
                                         "aoIrradianceLight(cones, direction, 1.0).r, 0.0")) {
        ASSERT_EQ(pixel, glm::vec4(0.0F));
    }
}

TEST_P(EnvironmentLightGLTest, BrighterThanHalvesIsCut) {
    EnvironmentMap map{4, 2, std::vector<glm::vec3>(8, glm::vec3(1e6F))};
    Result<EnvironmentLight> light =
        EnvironmentLight::create(loader, map, {.cones = kCones, .angles = true});
    ASSERT_TRUE(light);
    light_.emplace(std::move(*light));
    EXPECT_EQ(shaded("aoConeLight(cones, direction, direction, 1.0), 1.0")[77].x, 65504.0F);
}

TEST_P(EnvironmentLightGLTest, MistakesAreNamed) {
    EXPECT_EQ(
        EnvironmentLight::create(loader, map_, {.cones = kCones, .angles = true, .anglesSize = 0})
            .status()
            .code(),
        StatusCode::InvalidOption);
    EXPECT_EQ(EnvironmentLight::create(loader, {3, 3, {}}).status().code(),
              StatusCode::InvalidOption);
    EXPECT_EQ(EnvironmentLight::create([](const char*) -> void* { return nullptr; }, map_)
                  .status()
                  .code(),
              StatusCode::NoContext);
    EXPECT_EQ(
        static_cast<unsigned>(
            EnvironmentLight::create(loader, map_, {.cones = kCones, .angles = false})->angles()),
        0U);
    EXPECT_GT(light_->bytes(), std::size_t{128 * 64 * 6});
}

AOLIB_FOR_ALL_CONTEXTS(EnvironmentLightGLTest);

} // namespace
} // namespace aolib::lighting
