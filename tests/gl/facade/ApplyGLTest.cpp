// Hosts that render to textures of their own: aoApply() gives them the ambient occlusion, or
// blends.
#include <cmath>
#include <limits>
#include <utility>

#include "SmallScene.h"

namespace aolib {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 90;
constexpr glm::ivec2 kSize{kWidth, kHeight};
constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();

Options applyOptions(Backbone backbone = Backbone::Cubemapped) {
    Options options = atOnce();
    options.backbone = backbone;
    options.estimator = Estimator::LayeredIntervals;
    options.radius = 1.0F;
    options.cubeMaps.faceSize = 128;
    options.cubeMaps.refineStaticViews = false; // a second call is another picture
    return options;
}

class ApplyGLTest : public GLTest {
protected:
    void TearDown() override {
        textures_.clear();
        framebuffer_ = {};
        GLTest::TearDown();
    }

    TextureName texture(GLenum internalFormat, GLenum format, GLenum type,
                        const void* data = nullptr, GLenum target = GL_TEXTURE_2D) {
        textures_.push_back(gl::generate<gl::Texture>(gl, &gl::Functions::GenTextures));
        const GLuint name = textures_.back().name();
        gl.BindTexture(target, name);
        if (target == GL_TEXTURE_2D) {
            gl.TexImage2D(target, 0, static_cast<GLint>(internalFormat), kWidth, kHeight, 0, format,
                          type, data);
        } else if (target == GL_TEXTURE_2D_ARRAY) {
            gl.TexImage3D(target, 0, static_cast<GLint>(internalFormat), kWidth, kHeight, 3, 0,
                          format, type, data);
        } else {
            using Multisample =
                void(APIENTRY*)(GLenum, GLsizei, GLenum, GLsizei, GLsizei, GLboolean);
            reinterpret_cast<Multisample>(loader("glTexImage2DMultisample"))(
                target, 4, internalFormat, kWidth, kHeight, GL_TRUE);
        }
        gl.BindTexture(target, 0);
        return TextureName{name};
    }
    TextureName depth24() {
        return texture(GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
    }
    TextureName colour8() { return texture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE); }

    /// Draws the host's picture into its textures, as a renderer with targets of its own does.
    void drawInto(SmallHost& host, TextureName depth, TextureName colour,
                  GLenum target = GL_TEXTURE_2D) {
        if (!framebuffer_) {
            framebuffer_ = gl::generate<gl::Framebuffer>(gl, &gl::Functions::GenFramebuffers);
        }
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, target,
                                static_cast<GLuint>(colour), 0);
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, target,
                                static_cast<GLuint>(depth), 0);
        gl.Viewport(0, 0, kWidth, kHeight);
        host.renderer().draw(host.view(), host.projection());
        gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
        ASSERT_TRUE(host.ao().aoSetCamera(host.view(), host.projection()).ok());
    }
    /// Red values of a texture as bytes.
    std::vector<GLubyte> red(TextureName texture) {
        std::vector<GLubyte> bytes(static_cast<std::size_t>(kWidth * kHeight));
        gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
        gl.BindTexture(GL_TEXTURE_2D, static_cast<GLuint>(texture));
        gl.GetTexImage(GL_TEXTURE_2D, 0, GL_RED, GL_UNSIGNED_BYTE, bytes.data());
        gl.BindTexture(GL_TEXTURE_2D, 0);
        return bytes;
    }
    /// The root of the mean squared difference of two pictures, background left out.
    static double difference(const VisibilityImage& a, const VisibilityImage& b) {
        double sum = 0.0;
        int count = 0;
        for (std::size_t i = 0; i < a.visibility.size(); ++i) {
            if (a.visibility[i] >= 0 && b.visibility[i] >= 0) {
                sum += std::pow(a.visibility[i] - b.visibility[i], 2);
                ++count;
            }
        }
        EXPECT_GT(count, 1000);
        return std::sqrt(sum / count);
    }

private:
    std::vector<gl::Texture> textures_;
    gl::Framebuffer framebuffer_;
};

TEST_P(ApplyGLTest, GivesTheFactorOfAFrame) {
    for (const Backbone backbone : {Backbone::Cubemapped, Backbone::ScreenSpace}) {
        SmallHost host(gl, loader, boxOnFloor(), applyOptions(backbone));
        host.lookAt({4, 4, 6}, {0, 0.5F, 0});
        ASSERT_TRUE(host.frame().ok()) << host.ao().lastStatus().message();
        const VisibilityImage expected = host.visibility();
        const TextureName depth = depth24();
        drawInto(host, depth, colour8());
        const auto applied = host.ao().aoApply({.size = kSize, .depth = depth}, host.eye());
        ASSERT_TRUE(applied.ok()) << applied.status().message();
        const std::vector<GLubyte> factor = red(*applied);
        int dark = 0;
        for (std::size_t i = 0; i < factor.size(); ++i) {
            const float w = expected.visibility[i] < 0 ? 1.0F : expected.visibility[i];
            ASSERT_NEAR(factor[i], 255.0F * w, 1.0F) << "pixel " << i;
            dark += w < 0.8F ? 1 : 0;
        }
        EXPECT_GT(dark, 50) << "the test would see nothing";
        EXPECT_EQ(host.visibility().visibility, expected.visibility);
    }
}

TEST_P(ApplyGLTest, BlendsIntoTheHostsColours) {
    SmallHost host(gl, loader, boxOnFloor(), applyOptions());
    host.lookAt({4, 4, 6}, {0, 0.5F, 0});
    const TextureName depth = depth24();
    const TextureName colour = colour8();
    drawInto(host, depth, colour);
    const std::vector<GLubyte> before = red(colour);
    const std::vector<GLubyte> factor =
        red(*host.ao().aoApply({.size = kSize, .depth = depth}, host.eye()));
    EXPECT_EQ(red(colour), before) << "nobody asked to blend";
    const auto applied =
        host.ao().aoApply({.size = kSize, .depth = depth, .colour = colour}, host.eye());
    ASSERT_TRUE(applied.ok()) << applied.status().message();
    EXPECT_EQ(*applied, TextureName{});
    const std::vector<GLubyte> after = red(colour);
    for (std::size_t i = 0; i < before.size(); ++i) {
        ASSERT_NEAR(after[i], before[i] * factor[i] / 255.0F, 1.5F) << "pixel " << i;
    }
    EXPECT_NE(after, before);
}

TEST_P(ApplyGLTest, NormalsOfTheHostCount) {
    SmallHost host(gl, loader, boxOnFloor(), applyOptions(Backbone::ScreenSpace));
    host.lookAt({0, 6, 0.5F}, {0, 0, 0}); // straight down: every surface in view faces up
    const TextureName depth = depth24();
    drawInto(host, depth, colour8());
    const auto withNormals = [&](TextureName normal) {
        const auto applied =
            host.ao().aoApply({.size = kSize, .depth = depth, .normal = normal}, host.eye());
        EXPECT_TRUE(applied.ok()) << applied.status().message();
        return host.visibility();
    };
    const VisibilityImage own = withNormals(TextureName{});
    const auto filled = [&](glm::vec3 n, GLenum format) {
        std::vector<glm::vec3> all(static_cast<std::size_t>(kWidth * kHeight), n);
        return texture(format, GL_RGB, GL_FLOAT, all.data());
    };
    // What the depth says anyway, in every encoding; of any length; on either side.
    EXPECT_LT(difference(own, withNormals(filled({0, 1, 0}, GL_RGBA16F))), 0.01);
    EXPECT_LT(difference(own, withNormals(filled({0, -0.5F, 0}, GL_RGBA32F))), 0.01);
    EXPECT_LT(difference(own, withNormals(filled({0.5F, 1, 0.5F}, GL_RGBA8))), 0.01);
    EXPECT_LT(difference(own, withNormals(filled({0.5F, 1, 0.5F}, GL_RGB10_A2))), 0.01);
    // None: the depth's are taken.
    EXPECT_EQ(withNormals(filled({0, 0, 0}, GL_RGBA16F)).visibility, own.visibility);
    EXPECT_EQ(withNormals(filled({kNotANumber, 0, 0}, GL_RGBA32F)).visibility, own.visibility);
    // Others: a surface that leans sees less.
    EXPECT_GT(difference(own, withNormals(filled({1, 1, 0}, GL_RGBA16F))), 0.05);
}

TEST_P(ApplyGLTest, SamplesOfTheHostAreResolved) {
    SmallHost host(gl, loader, boxOnFloor(), applyOptions());
    host.lookAt({4, 4, 6}, {0, 0.5F, 0});
    const TextureName single = depth24();
    drawInto(host, single, colour8());
    ASSERT_TRUE(host.ao().aoApply({.size = kSize, .depth = single}, host.eye()).ok());
    const VisibilityImage expected = host.visibility();
    const auto samples = [&](GLenum format) {
        return texture(format, 0, 0, nullptr, GL_TEXTURE_2D_MULTISAMPLE);
    };
    const TextureName depth = samples(GL_DEPTH24_STENCIL8);
    const TextureName colour = samples(GL_RGBA8);
    drawInto(host, depth, colour, GL_TEXTURE_2D_MULTISAMPLE);
    const auto apart = host.ao().aoApply({.size = kSize, .depth = depth}, host.eye());
    ASSERT_TRUE(apart.ok()) << apart.status().message();
    // Pixels that show several surfaces take the mean of them all.
    const VisibilityImage means = host.visibility();
    EXPECT_LT(difference(expected, means), 0.03);
    const std::vector<GLubyte> factor = red(*apart);
    const float contrast = applyOptions().contrast;
    for (std::size_t i = 0; i < factor.size(); ++i) {
        const float w = means.visibility[i] < 0.0F ? 1.0F : means.visibility[i];
        ASSERT_NEAR(factor[i], 255.0F * (1.0F - contrast + contrast * w), 1.0F) << "pixel " << i;
    }
    const auto blended =
        host.ao().aoApply({.size = kSize, .depth = depth, .colour = colour}, host.eye());
    EXPECT_TRUE(blended.ok()) << blended.status().message();
    EXPECT_EQ(
        host.ao()
            .aoApply({.size = kSize, .depth = depth, .normal = samples(GL_RGBA16F)}, host.eye())
            .status()
            .code(),
        StatusCode::InvalidFramebuffer);
}

TEST_P(ApplyGLTest, RefusesWhatIsOfNoUse) {
    SmallHost host(gl, loader, boxOnFloor(), applyOptions());
    host.lookAt({4, 4, 6}, {0, 0.5F, 0});
    const TextureName depth = depth24();
    const TextureName colour = colour8();
    const TextureName array =
        texture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, nullptr, GL_TEXTURE_2D_ARRAY);
    const TextureName integers = texture(GL_RGBA32I, GL_RGBA_INTEGER, GL_INT);
    const auto refused = [&](const HostTextures& textures) {
        const auto applied = host.ao().aoApply(textures, host.eye());
        EXPECT_FALSE(applied.ok());
        EXPECT_NE(applied.status().message(), "");
        return applied.status().code();
    };
    EXPECT_EQ(refused({.size = kSize, .depth = depth}),
              GetParam().profile == ContextRequest::Profile::Core ? StatusCode::NoCamera
                                                                  : StatusCode::InvalidCamera);
    drawInto(host, depth, colour);
    constexpr StatusCode kInvalid = StatusCode::InvalidFramebuffer;
    EXPECT_EQ(refused({.size = kSize}), kInvalid) << "no depth";
    EXPECT_EQ(refused({.size = kSize, .depth = TextureName{4711}}), kInvalid) << "no texture";
    EXPECT_EQ(refused({.size = kSize, .depth = colour}), kInvalid) << "no depth in it";
    EXPECT_EQ(refused({.size = {0, kHeight}, .depth = depth}), kInvalid) << "no size";
    EXPECT_EQ(refused({.size = kSize, .depth = depth, .normal = depth}), kInvalid);
    EXPECT_EQ(refused({.size = kSize, .depth = depth, .normal = integers}), kInvalid);
    EXPECT_EQ(refused({.size = kSize, .depth = depth, .normal = array}), kInvalid);
    EXPECT_EQ(refused({.size = kSize, .depth = depth, .colour = array}), kInvalid);
    EXPECT_EQ(refused({.size = kSize, .depth = depth, .colour = TextureName{4711}}), kInvalid);
    EXPECT_TRUE(host.ao().aoApply({.size = kSize, .depth = depth}, host.eye()).ok())
        << host.ao().lastStatus().message();
}

TEST_P(ApplyGLTest, TexturesAreNotKeptAlive) {
    SmallHost host(gl, loader, boxOnFloor(), applyOptions());
    host.lookAt({4, 4, 6}, {0, 0.5F, 0});
    const TextureName depth = depth24();
    const TextureName colour = colour8();
    drawInto(host, depth, colour);
    const HostTextures textures{.size = kSize, .depth = depth, .colour = colour};
    ASSERT_TRUE(host.ao().aoApply(textures, host.eye()).ok());
    const auto name = static_cast<GLuint>(depth);
    bool hostsOwn = false;
    for (GLuint framebuffer = 1; framebuffer < 64; ++framebuffer) {
        using IsFramebuffer = GLboolean(APIENTRY*)(GLuint);
        if (reinterpret_cast<IsFramebuffer>(loader("glIsFramebuffer"))(framebuffer) == GL_FALSE) {
            continue;
        }
        gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        GLint type = GL_NONE;
        GLint attached = 0;
        gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                               GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &type);
        if (type == GL_TEXTURE) {
            gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                                   GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME,
                                                   &attached);
        }
        if (static_cast<GLuint>(attached) == name) {
            gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_TEXTURE_2D, 0,
                                    0);
            EXPECT_FALSE(std::exchange(hostsOwn, true)) << "one of aolib's holds it, too";
        }
    }
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    EXPECT_TRUE(hostsOwn) << "the test must find the host's own";
}

AOLIB_FOR_ALL_CONTEXTS(ApplyGLTest);

} // namespace
} // namespace aolib
