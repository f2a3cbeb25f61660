// Every camera and framebuffer that a host may have, against truth: the error of what ends up in
// the host's own colours differs little from that of a plain perspective camera.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <glm/gtc/matrix_transform.hpp>

#include "CoreContexts.h"
#include "SmallScene.h"
#include "TracedView.h"
#include "gl/GLSLShader.h"
#include "gl/RenderToTexture2D.h"
#include "gl/VertexArray.h"
#include "host/ModelScene.h"

namespace aolib::test {
namespace {

constexpr int kWidth = 240;
constexpr int kHeight = 136;
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;
constexpr int kRays = 400;
/// Issue "the best guest": how far the error of a kind may be from the plain one's.
constexpr double kMostApart = 0.005;
const glm::dvec3 kTarget{0.0, 0.5, 0.0};
const glm::dvec3 kEye{4.0, 4.0, 6.0}; ///< where the cube map stands, too
/// Half the height of what an orthographic camera sees, and how many times as far away a
/// perspective one stands that sees nearly the same.
constexpr double kHalfHeight = 3.0;
constexpr double kAfar = 12.0;

/// A projection, the one that shows the same pixels to the tracer, and what GL must be told.
struct CameraKind {
    glm::dmat4 projection{1.0};
    glm::dmat4 traced{1.0};
    bool zeroToOne = false;
    bool upperLeft = false;
    bool reversed = false;
    bool mirrored = false;            ///< rows of the picture run downwards
    double distance = 1.0;            ///< of the eye from the target, as multiples of kEye's
    std::string like = "perspective"; ///< the plain camera that sees the same
    std::array<double, 2> depthRange{0.0, 1.0};
};

struct Framebuffer {
    GLenum colour = GL_RGBA8;
    GLenum depth = GL_DEPTH24_STENCIL8;
    int samples = 0;
    bool depthTexture = false;
    float white = 1.0F;    ///< what the host draws
    glm::ivec2 origin{0};  ///< of the viewport; the framebuffer is larger by twice that
    bool scissor = false;  ///< around the viewport
    bool textures = false; ///< by aoApply
    bool resized = false;  ///< after a frame of another size
};

/// Clip depth [-1,1] to [0,1], near to far.
glm::dmat4 toZeroToOne(const glm::dmat4& projection) {
    glm::dmat4 map(1.0);
    map[2][2] = 0.5;
    map[3][2] = 0.5;
    return map * projection;
}
/// Near becomes far.
glm::dmat4 reversed(const glm::dmat4& projection) {
    return glm::scale(glm::dmat4(1.0), {1.0, 1.0, -1.0}) * projection;
}
glm::dmat4 plain() {
    return glm::perspectiveRH_NO(glm::radians(60.0), kAspect, 0.5, 40.0);
}
glm::dmat4 infinite() {
    return glm::tweakedInfinitePerspective(glm::radians(60.0), kAspect, 0.5, 0.0);
}

std::map<std::string, CameraKind> cameraKinds() {
    std::map<std::string, CameraKind> kinds;
    const auto add = [&](const char* name, const glm::dmat4& traced) -> CameraKind& {
        kinds[name] = {.projection = traced, .traced = traced};
        return kinds[name];
    };
    add("perspective", plain());
    add("off-centre", glm::frustumRH_NO(-0.8, 0.3, -0.2, 0.35, 0.6, 40.0));
    add("orthographic", glm::orthoRH_NO(-kHalfHeight * kAspect, kHalfHeight * kAspect, -kHalfHeight,
                                        kHalfHeight, 0.5, 40.0))
        .like = "perspective from afar";
    const double away = kAfar * glm::distance(kEye, kTarget);
    add("perspective from afar", glm::perspectiveRH_NO(2.0 * std::atan(kHalfHeight / away), kAspect,
                                                       away - 10.0, away + 20.0))
        .distance = kAfar;
    kinds["perspective from afar"].like = "perspective from afar";
    add("infinite far", infinite());
    CameraKind& backwards = add("reversed", plain());
    backwards.projection = reversed(plain());
    backwards.reversed = true;
    CameraKind& modern = add("reversed, [0,1], infinite far", infinite());
    modern.projection = toZeroToOne(reversed(infinite()));
    modern.reversed = modern.zeroToOne = true;
    CameraKind& direct = add("[0,1]", plain());
    direct.projection = toZeroToOne(plain());
    direct.zeroToOne = true;
    add("upper left", plain()).upperLeft = true;
    kinds["upper left"].mirrored = true;
    CameraKind& flipped = add("y flipped", plain());
    flipped.projection[1][1] *= -1.0;
    flipped.mirrored = true;
    CameraKind& range = add("depth range reversed", plain());
    range.depthRange = {1.0, 0.0};
    range.reversed = true;
    add("depth range within", plain()).depthRange = {0.25, 0.5};
    return kinds;
}

std::map<std::string, Framebuffer> framebufferKinds() {
    return {
        {"16 bits of depth", {.depth = GL_DEPTH_COMPONENT16}},
        {"floating-point depth texture", {.depth = GL_DEPTH_COMPONENT32F, .depthTexture = true}},
        {"2 samples", {.samples = 2}},
        {"4 samples", {.samples = 4}},
        {"8 samples", {.samples = 8}},
        {"sRGB", {.colour = GL_SRGB8_ALPHA8}},
        {"HDR", {.colour = GL_RGBA16F, .white = 6.0F}},
        {"ten bits", {.colour = GL_RGB10_A2}},
        {"sub-viewport", {.origin = {17, 9}}},
        {"sub-viewport, scissored", {.origin = {17, 9}, .scissor = true}},
        {"resized", {.resized = true}},
        {"own textures", {.depthTexture = true, .textures = true}}};
}

Model boxes() {
    Model model;
    addQuad(model, {-8, 0, -8}, {-8, 0, 8}, {8, 0, 8}, {8, 0, -8});
    addBox(model, {-2, 0, -2}, {0, 2, 0});
    addBox(model, {0.5F, 0, -1}, {2, 1, 1});
    addBox(model, {-1, 0, 1}, {0, 0.5F, 2.5F});
    return model;
}

glm::dvec3 eyeOf(const CameraKind& camera) {
    return kTarget + camera.distance * (kEye - kTarget);
}
glm::dmat4 viewOf(const CameraKind& camera) {
    return glm::lookAt(eyeOf(camera), kTarget, glm::dvec3(0.0, 1.0, 0.0));
}

/// A host that draws everything in one colour: then its picture is that colour times W.
class WhiteHost {
public:
    WhiteHost(const gl::Functions& gl, const Model& model) : gl_(gl) {
        const TriangleMesh all = model.flattened();
        vertices_ = std::move(
            *gl::VertexArray::createTriangles(gl, {all.positions, {}, {}, all.indices}, "host"));
        auto shader = gl::GLSLShader::build(
            gl,
            {"white.vert",
             "#version 330 core\nlayout(location = 0) in vec3 position;\n"
             "uniform mat4 view;\nuniform mat4 projection;\n"
             "void main() { gl_Position = projection * (view * vec4(position, 1)); }"},
            {"white.frag", "#version 330 core\nuniform float white;\nout vec4 colour;\n"
                           "void main() { colour = vec4(vec3(white), 1); }"});
        EXPECT_TRUE(shader.ok()) << shader.status().message();
        shader_ = std::move(*shader);
    }
    void draw(const CameraKind& camera, float white) {
        const std::array<float, 4> sky{white, white, white, 1.0F};
        const double far = camera.reversed ? 0.0 : 1.0;
        const auto cleared = static_cast<float>(camera.depthRange[0] == 0.25 ? 0.5 : far);
        gl_.ClearBufferfv(GL_COLOR, 0, sky.data());
        gl_.ClearBufferfv(GL_DEPTH, 0, &cleared);
        gl_.Enable(GL_DEPTH_TEST);
        gl_.DepthFunc(camera.reversed ? GL_GREATER : GL_LESS);
        shader_.bind();
        shader_.set("view", glm::mat4(viewOf(camera)));
        shader_.set("projection", glm::mat4(camera.projection));
        shader_.set("white", white);
        vertices_.drawTriangles();
    }

private:
    const gl::Functions& gl_;
    gl::VertexArray vertices_;
    gl::GLSLShader shader_;
};

/// A picture without the pixels beside background: several samples mix with it there.
FloatImage inner(const FloatImage& picture) {
    FloatImage image = picture;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            for (int i = 0; i < 9; ++i) {
                const int nx = std::clamp(x + i % 3 - 1, 0, kWidth - 1);
                const int ny = std::clamp(y + i / 3 - 1, 0, kHeight - 1);
                if (picture.pixels[static_cast<std::size_t>(ny * kWidth + nx)] < 0.0F) {
                    image.pixels[static_cast<std::size_t>(y * kWidth + x)] = backgroundValue;
                }
            }
        }
    }
    return image;
}

class HostKindsGLTest : public GLTest {
protected:
    using Renderbuffer = gl::Handle<&gl::Functions::DeleteRenderbuffers>;

    void SetUp() override {
        GLTest::SetUp();
        if (!IsSkipped() && !HasFatalFailure()) {
            model_ = boxes();
            host_.emplace(gl, model_);
        }
    }
    void TearDown() override {
        host_.reset();
        ao_.reset();
        GLTest::TearDown();
    }

    /// The traced picture of a camera: of the pixels' centres, or the mean over their samples.
    FloatImage truth(const CameraKind& camera, int samples) {
        if (samples == 0) {
            return traced(camera, glm::dvec2(0.0));
        }
        using Position = void(APIENTRY*)(GLenum, GLuint, GLfloat*);
        const auto position = reinterpret_cast<Position>(loader("glGetMultisamplefv"));
        FloatImage mean(kWidth, kHeight, 1, 0.0F);
        for (int i = 0; i < samples; ++i) {
            std::array<GLfloat, 2> at{};
            position(GL_SAMPLE_POSITION, static_cast<GLuint>(i), at.data());
            const FloatImage one = traced(camera, glm::dvec2(at[0], at[1]) - 0.5);
            for (std::size_t k = 0; k < mean.pixels.size(); ++k) {
                const bool background = one.pixels[k] < 0.0F || mean.pixels[k] < 0.0F;
                mean.pixels[k] = background
                                     ? backgroundValue
                                     : mean.pixels[k] + one.pixels[k] / static_cast<float>(samples);
            }
        }
        return mean;
    }
    /// @param offset  from the pixels' centres, pixels.
    FloatImage traced(const CameraKind& camera, const glm::dvec2& offset) {
        const glm::dvec3 shift(-2.0 * offset.x / kWidth, -2.0 * offset.y / kHeight, 0.0);
        const glm::dmat4 projection = glm::translate(glm::dmat4(1.0), shift) * camera.traced;
        const glm::dmat4 key = projection * viewOf(camera);
        for (const auto& [known, image] : truths_) {
            if (known == key) {
                return image;
            }
        }
        const Result<RayScene> scene = RayScene::create(model_.flattened());
        PictureSettings settings;
        settings.trace.rays = kRays;
        settings.trace.radius = 1.5;
        const Result<Picture> picture =
            tracePicture(*scene, {viewOf(camera), projection, kWidth, kHeight}, settings);
        EXPECT_TRUE(picture.ok()) << picture.status().message();
        truths_.emplace_back(key, visibilityOf(*picture));
        return truths_.back().second;
    }

    /// The error of W, as the host's colours tell it.
    double error(const CameraKind& camera, const Framebuffer& kind);
    void frame(const CameraKind& camera, const Framebuffer& kind, const HostTextures& textures);
    FloatImage colours(const CameraKind& camera, const Framebuffer& kind);
    void expectAlike(const std::string& name, const CameraKind& camera, const Framebuffer& kind) {
        const double plainError = error(cameraKinds().at(camera.like), {});
        const double found = error(camera, kind);
        RecordProperty(name, std::to_string(found));
        std::cout << "    " << name << ": RMSE " << found << ", plain " << plainError << '\n';
        EXPECT_LE(std::abs(found - plainError), kMostApart) << name;
        EXPECT_GT(plainError, 1e-4) << "the test would see nothing";
    }

    Model model_;
    std::optional<WhiteHost> host_;
    std::optional<AmbientOcclusion> ao_;
    std::vector<std::pair<glm::dmat4, FloatImage>> truths_;
};

void HostKindsGLTest::frame(const CameraKind& camera, const Framebuffer& kind,
                            const HostTextures& textures) {
    const auto whole = glm::ivec2(kWidth, kHeight) + 2 * kind.origin;
    const glm::vec3 eye(eyeOf(camera));
    gl.DepthRange(camera.depthRange[0], camera.depthRange[1]);
    if (gl.capabilities.clipControl) {
        gl.ClipControl(camera.upperLeft ? GL_UPPER_LEFT : GL_LOWER_LEFT,
                       camera.zeroToOne ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
    }
    if (kind.colour == GL_SRGB8_ALPHA8) {
        gl.Enable(GL_FRAMEBUFFER_SRGB);
    }
    EXPECT_TRUE(ao_->aoSetCamera(glm::mat4(viewOf(camera)), glm::mat4(camera.projection)).ok());
    if (kind.resized) {
        gl.Viewport(0, 0, whole.x / 2, whole.y / 2);
        EXPECT_TRUE(ao_->aoDrawBegin().ok());
        host_->draw(camera, kind.white);
        EXPECT_TRUE(ao_->aoDrawEnd(eye.x, eye.y, eye.z).ok());
    }
    gl.Viewport(kind.origin.x, kind.origin.y, kWidth, kHeight);
    if (kind.scissor) {
        gl.Enable(GL_SCISSOR_TEST);
        gl.Scissor(kind.origin.x, kind.origin.y, kWidth, kHeight);
    }
    Status status = ao_->aoDrawBegin();
    EXPECT_TRUE(status.ok()) << status.message();
    host_->draw(camera, kind.white);
    const auto applied =
        kind.textures ? ao_->aoApply(textures, eye) : Result<TextureName>(TextureName{});
    status = ao_->aoDrawEnd(eye.x, eye.y, kind.textures ? std::nanf("") : eye.z);
    EXPECT_EQ(status.ok(), !kind.textures) << status.message();
    EXPECT_TRUE(applied.ok()) << applied.status().message();
    gl.Disable(GL_SCISSOR_TEST);
    gl.Disable(GL_FRAMEBUFFER_SRGB);
    gl.Disable(GL_DEPTH_TEST);
    gl.DepthRange(0.0, 1.0);
    if (gl.capabilities.clipControl) {
        gl.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    }
}

FloatImage HostKindsGLTest::colours(const CameraKind& camera, const Framebuffer& kind) {
    std::vector<float> rgba(4 * static_cast<std::size_t>(kWidth * kHeight));
    gl.ReadPixels(kind.samples > 0 ? 0 : kind.origin.x, kind.samples > 0 ? 0 : kind.origin.y,
                  kWidth, kHeight, GL_RGBA, GL_FLOAT, rgba.data());
    FloatImage image(kWidth, kHeight, 1);
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const int row = camera.mirrored ? kHeight - 1 - y : y;
            double value =
                static_cast<double>(rgba[4 * static_cast<std::size_t>(row * kWidth + x)]);
            if (kind.colour == GL_SRGB8_ALPHA8) {
                value = value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
            }
            image.pixels[static_cast<std::size_t>(y * kWidth + x)] =
                static_cast<float>(value / static_cast<double>(kind.white));
        }
    }
    return image;
}

double HostKindsGLTest::error(const CameraKind& camera, const Framebuffer& kind) {
    if (!ao_) {
        Options options;
        options.frameBudget = 0.0F;
        options.estimator = Estimator::LayeredIntervals;
        options.radius = 1.5F;
        options.cubeMaps.faceSize = 256;
        options.cubeMaps.place = false;
        ao_.emplace(std::move(*AmbientOcclusion::create(loader, options)));
        EXPECT_TRUE(host::describeScene(*ao_, model_, host::SceneNormals::Geometric).ok());
        EXPECT_TRUE(ao_->addCubeMap(glm::vec3(kEye)).ok());
    }
    const auto whole = glm::ivec2(kWidth, kHeight) + 2 * kind.origin;
    auto framebuffer = gl::generate<gl::Framebuffer>(gl, &gl::Functions::GenFramebuffers);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    std::vector<Renderbuffer> buffers;
    std::vector<gl::Texture> textures;
    const auto attach = [&](GLenum attachment, GLenum format, bool asTexture) {
        if (asTexture) {
            textures.push_back(gl::generate<gl::Texture>(gl, &gl::Functions::GenTextures));
            gl.BindTexture(GL_TEXTURE_2D, textures.back().name());
            const bool depth = attachment != GL_COLOR_ATTACHMENT0;
            const bool packed = format == GL_DEPTH24_STENCIL8;
            gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), whole.x, whole.y, 0,
                          packed  ? GL_DEPTH_STENCIL
                          : depth ? GL_DEPTH_COMPONENT
                                  : GL_RGBA,
                          packed  ? GL_UNSIGNED_INT_24_8
                          : depth ? GL_FLOAT
                                  : GL_UNSIGNED_BYTE,
                          nullptr);
            gl.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D,
                                    textures.back().name(), 0);
            return;
        }
        buffers.push_back(gl::generate<Renderbuffer>(gl, &gl::Functions::GenRenderbuffers));
        gl.BindRenderbuffer(GL_RENDERBUFFER, buffers.back().name());
        gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, kind.samples, format, whole.x, whole.y);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER,
                                   buffers.back().name());
    };
    attach(kind.depth == GL_DEPTH24_STENCIL8 ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
           kind.depth, kind.depthTexture);
    attach(GL_COLOR_ATTACHMENT0, kind.colour, kind.textures);
    EXPECT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER),
              static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    HostTextures given{.size = whole};
    if (kind.textures) {
        given.depth = TextureName{textures[0].name()};
        given.colour = TextureName{textures[1].name()};
    }
    frame(camera, kind, given);
    GLint samples = 0; // maybe more than were asked for
    gl.GetIntegerv(GL_SAMPLES, &samples);
    const FloatImage wanted = truth(camera, samples);
    const FloatImage expected = inner(wanted);
    std::optional<gl::RenderToTexture2D> resolved;
    if (kind.samples > 0) {
        resolved.emplace(std::move(
            *gl::RenderToTexture2D::create(gl, {.width = kWidth,
                                                .height = kHeight,
                                                .targets = {gl::RenderToTexture2D::Format::RGBA8},
                                                .label = "resolved"})));
        gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.name());
        gl.BlitFramebuffer(0, 0, kWidth, kHeight, 0, 0, kWidth, kHeight, GL_COLOR_BUFFER_BIT,
                           GL_NEAREST);
        resolved->beginRead(0);
    }
    const FloatImage shown = colours(camera, kind);
    const double found = rmse(shown, expected);
    int darkSky = 0;
    for (std::size_t i = kWidth; i + kWidth < shown.pixels.size(); ++i) {
        const bool sky =
            wanted.pixels[i - kWidth] < 0 && wanted.pixels[i] < 0 && wanted.pixels[i + kWidth] < 0;
        darkSky += sky && shown.pixels[i] < 0.99F ? 1 : 0;
    }
    EXPECT_LT(darkSky, kWidth) << "the background is not the host's";
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
    return found;
}

TEST_P(HostKindsGLTest, CamerasAreAsGoodAsThePlainOne) {
    for (const auto& [name, camera] : cameraKinds()) {
        if ((camera.zeroToOne || camera.upperLeft) && !gl.capabilities.clipControl) {
            std::cout << "    " << name << ": NOT TESTED without clip control\n";
            continue;
        }
        expectAlike(name, camera, {});
    }
}

TEST_P(HostKindsGLTest, FramebuffersAreAsGoodAsThePlainOne) {
    for (const auto& [name, kind] : framebufferKinds()) {
        GLint most = 0;
        gl.GetIntegerv(GL_MAX_SAMPLES, &most);
        if (kind.samples > most) {
            std::cout << "    " << name << ": NOT TESTED, this driver has " << most << '\n';
            continue;
        }
        expectAlike(name, cameraKinds().at("perspective"), kind);
    }
}

TEST_P(HostKindsGLTest, InstancesDoNotKnowOfEachOther) {
    const CameraKind camera = cameraKinds().at("perspective");
    const double alone = error(camera, {});
    std::optional<AmbientOcclusion> first = std::move(ao_);
    ao_.reset();
    EXPECT_EQ(error(camera, {}), alone);
    std::swap(first, ao_);
    EXPECT_EQ(error(camera, {}), alone);
    first.reset();
    EXPECT_EQ(error(camera, {}), alone) << "after the other's end";
}

AOLIB_FOR_CORE_CONTEXTS(HostKindsGLTest);

} // namespace
} // namespace aolib::test
