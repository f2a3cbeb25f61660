#include "MeasuredHost.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <aolib/RayTracing.h>

#include "TracedView.h"
#include "gl/RenderToTexture2D.h"
#include "host/ModelScene.h"

namespace aolib::test {

namespace {

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

/// Frames until a picture at rest is complete, at most.
constexpr int kMostFramesAtRest = 50;

/// The options of all.
Options measuredOptions(MeasuredHost::View view) {
    Options options;
    if (view == MeasuredHost::View::AtRest) {
        options.layeredIntervals = {.slices = 4, .steps = 8}; // quicker
    }
    options.cubeMaps.refineStaticViews = view == MeasuredHost::View::AtRest;
    options.frameBudget = 0.0F;
    options.estimator = Estimator::LayeredIntervals;
    options.radius = 1.5F;
    options.cubeMaps.faceSize = 256;
    options.cubeMaps.place = false;
    return options;
}

} // namespace

MeasuredHost::MeasuredHost(const gl::Functions& gl, ProcAddressLoader loader, const Model& model,
                           TracedKinds& truth, View view)
    : MeasuredHost(gl, std::move(loader), model, truth, view, measuredOptions(view)) {}

MeasuredHost::MeasuredHost(const gl::Functions& gl, ProcAddressLoader loader, const Model& model,
                           TracedKinds& truth, const Options& options)
    : MeasuredHost(gl, std::move(loader), model, truth, View::AtRest, options) {}

MeasuredHost::MeasuredHost(const gl::Functions& gl, ProcAddressLoader loader, const Model& model,
                           TracedKinds& truth, View view, const Options& options)
    : gl_(gl), loader_(std::move(loader)), truth_(truth), view_(view), host_(gl, model) {
    auto ao = AmbientOcclusion::create(loader_, options);
    EXPECT_TRUE(ao.ok()) << ao.status().message();
    ao_.emplace(std::move(*ao));
    EXPECT_TRUE(host::describeScene(*ao_, model, host::SceneNormals::Geometric).ok());
    if (options.estimator == Estimator::RayTraced) {
        ao_->setTexelTracer(std::move(*createTexelTracer(2)));
    }
    if (options.backbone == Backbone::Cubemapped) {
        EXPECT_TRUE(ao_->addCubeMap(glm::vec3(kEye)).ok());
    }
}

/// What a host draws to.
struct MeasuredHost::Target {
    using Renderbuffer = gl::Handle<&gl::Functions::DeleteRenderbuffers>;

    gl::Framebuffer framebuffer;
    std::vector<Renderbuffer> buffers;
    std::vector<gl::Texture> textures; ///< depth, colour, where they are textures
};

MeasuredHost::Target MeasuredHost::make(const FramebufferKind& kind) const {
    Target target;
    if (kind.window) {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
        GLint twoBuffers = 0;
        gl_.GetIntegerv(GL_DOUBLEBUFFER, &twoBuffers);
        if (twoBuffers == GL_FALSE) {
            gl_.DrawBuffer(GL_FRONT); // Mesa begins with GL_BACK, in which glClearBuffer is lost
        }
        return target;
    }
    target.framebuffer = gl::generate<gl::Framebuffer>(gl_, &gl::Functions::GenFramebuffers);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    const auto whole = glm::ivec2(kWidth, kHeight) + 2 * kind.origin;
    const auto attach = [&](GLenum attachment, GLenum format, bool asTexture) {
        if (asTexture) {
            target.textures.push_back(gl::generate<gl::Texture>(gl_, &gl::Functions::GenTextures));
            gl_.BindTexture(GL_TEXTURE_2D, target.textures.back().name());
            const bool depth = attachment != GL_COLOR_ATTACHMENT0;
            const bool packed = format == GL_DEPTH24_STENCIL8;
            gl_.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), whole.x, whole.y, 0,
                           packed  ? GL_DEPTH_STENCIL
                           : depth ? GL_DEPTH_COMPONENT
                                   : GL_RGBA,
                           packed  ? GL_UNSIGNED_INT_24_8
                           : depth ? GL_FLOAT
                                   : GL_UNSIGNED_BYTE,
                           nullptr);
            gl_.FramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D,
                                     target.textures.back().name(), 0);
            return;
        }
        target.buffers.push_back(
            gl::generate<Target::Renderbuffer>(gl_, &gl::Functions::GenRenderbuffers));
        gl_.BindRenderbuffer(GL_RENDERBUFFER, target.buffers.back().name());
        gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, kind.samples, format, whole.x, whole.y);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER,
                                    target.buffers.back().name());
    };
    attach(kind.depth == GL_DEPTH24_STENCIL8 ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
           kind.depth, kind.depthTexture);
    attach(GL_COLOR_ATTACHMENT0, kind.colour, kind.textures);
    EXPECT_EQ(gl_.CheckFramebufferStatus(GL_FRAMEBUFFER),
              static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    return target;
}

void MeasuredHost::frame(const CameraKind& camera, const FramebufferKind& kind,
                         const HostTextures& textures) {
    const auto whole = glm::ivec2(kWidth, kHeight) + 2 * kind.origin;
    const glm::vec3 eye(eyeOf(camera));
    gl_.DepthRange(camera.depthRange[0], camera.depthRange[1]);
    if (gl_.capabilities.clipControl) {
        gl_.ClipControl(camera.upperLeft ? GL_UPPER_LEFT : GL_LOWER_LEFT,
                        camera.zeroToOne ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE);
    }
    if (kind.colour == GL_SRGB8_ALPHA8) {
        gl_.Enable(GL_FRAMEBUFFER_SRGB);
    }
    EXPECT_TRUE(ao_->aoSetCamera(glm::mat4(viewOf(camera)), glm::mat4(camera.projection)).ok());
    if (kind.resized) {
        gl_.Viewport(0, 0, whole.x / 2, whole.y / 2);
        EXPECT_TRUE(ao_->aoDrawBegin().ok());
        host_.draw(camera, kind.white);
        EXPECT_TRUE(ao_->aoDrawEnd(eye.x, eye.y, eye.z).ok());
    }
    gl_.Viewport(kind.origin.x, kind.origin.y, kWidth, kHeight);
    if (kind.scissor) {
        gl_.Enable(GL_SCISSOR_TEST);
        gl_.Scissor(kind.origin.x, kind.origin.y, kWidth, kHeight);
    }
    AoStatus status = ao_->aoDrawBegin();
    EXPECT_TRUE(status.ok()) << status.message();
    host_.draw(camera, kind.white);
    const auto applied =
        kind.textures ? ao_->aoApply(textures, eye) : Result<TextureName>(TextureName{});
    status = ao_->aoDrawEnd(eye.x, eye.y, kind.textures ? std::nanf("") : eye.z);
    EXPECT_EQ(status.ok(), !kind.textures) << status.message();
    EXPECT_TRUE(applied.ok()) << applied.status().message();
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.Disable(GL_FRAMEBUFFER_SRGB);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.DepthRange(0.0, 1.0);
    if (gl_.capabilities.clipControl) {
        gl_.ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    }
}

FloatImage MeasuredHost::expected(const CameraKind& camera, int samples) {
    if (samples == 0) {
        return truth_.of(camera);
    }
    FloatImage mean(kWidth, kHeight, 1, 0.0F);
    for (const FloatImage& one : sampleTruth(camera, samples)) {
        for (std::size_t k = 0; k < mean.pixels.size(); ++k) {
            const bool background = one.pixels[k] < 0.0F || mean.pixels[k] < 0.0F;
            mean.pixels[k] = background
                                 ? backgroundValue
                                 : mean.pixels[k] + one.pixels[k] / static_cast<float>(samples);
        }
    }
    return mean;
}

std::vector<FloatImage> MeasuredHost::sampleTruth(const CameraKind& camera, int samples) {
    using Position = void(APIENTRY*)(GLenum, GLuint, GLfloat*);
    const auto position = reinterpret_cast<Position>(loader_("glGetMultisamplefv"));
    std::vector<FloatImage> truth;
    for (int i = 0; i < samples; ++i) {
        std::array<GLfloat, 2> at{};
        position(GL_SAMPLE_POSITION, static_cast<GLuint>(i), at.data());
        const double up = camera.mirrored ? -1.0 : 1.0; // rows of the truth run upwards
        truth.push_back(truth_.of(camera, glm::dvec2(at[0] - 0.5, up * (at[1] - 0.5))));
    }
    return truth;
}

FloatImage MeasuredHost::colours(const CameraKind& camera, const FramebufferKind& kind) const {
    std::vector<float> rgba(4 * static_cast<std::size_t>(kWidth * kHeight));
    gl_.ReadPixels(kind.samples > 0 ? 0 : kind.origin.x, kind.samples > 0 ? 0 : kind.origin.y,
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

FloatImage MeasuredHost::resolvedColours(const CameraKind& camera, const FramebufferKind& kind,
                                         const Target& target) const {
    std::optional<gl::RenderToTexture2D> resolved;
    if (kind.samples > 0) {
        resolved.emplace(std::move(
            *gl::RenderToTexture2D::create(gl_, {.width = kWidth,
                                                 .height = kHeight,
                                                 .targets = {gl::RenderToTexture2D::Format::RGBA8},
                                                 .label = "resolved"})));
        gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer.name());
        gl_.BlitFramebuffer(kind.origin.x, kind.origin.y, kind.origin.x + kWidth,
                            kind.origin.y + kHeight, 0, 0, kWidth, kHeight, GL_COLOR_BUFFER_BIT,
                            GL_NEAREST);
        resolved->bindForReading(0);
    }
    return colours(camera, kind);
}

MeasuredHost::Samples MeasuredHost::samples(const CameraKind& camera, const FramebufferKind& kind) {
    const Target target = make(kind);
    for (int i = 0; i < kMostFramesAtRest; ++i) {
        gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
        frame(camera, kind, {});
        if (ao_->statistics().converged && i > 0) {
            break;
        }
    }
    EXPECT_TRUE(ao_->statistics().converged);
    GLint samples = 0; // maybe more than were asked for
    gl_.GetIntegerv(GL_SAMPLES, &samples);
    Samples result{
        .shown = {}, .read = FloatImage(kWidth, kHeight, 1), .truth = sampleTruth(camera, samples)};
    const auto read = ao_->readVisibility();
    EXPECT_TRUE(read.ok()) << read.status().message();
    for (int y = 0; y < kHeight; ++y) {
        const int row = camera.mirrored ? kHeight - 1 - y : y;
        for (int x = 0; x < kWidth; ++x) {
            result.read.pixels[static_cast<std::size_t>(y * kWidth + x)] =
                read->visibility[static_cast<std::size_t>(row * kWidth + x)];
        }
    }
    result.shown = resolvedColours(camera, kind, target);
    gl_.UseProgram(0); // it goes with this host
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    return result;
}

double MeasuredHost::error(const CameraKind& camera, const FramebufferKind& kind) {
    const Target target = make(kind);
    HostTextures given{.size = glm::ivec2(kWidth, kHeight) + 2 * kind.origin};
    if (kind.textures) {
        given.depth = TextureName{target.textures[0].name()};
        given.colour = TextureName{target.textures[1].name()};
    }
    frame(camera, kind, given);
    if (view_ == View::AtRest) {
        frame(camera, kind, given);
        EXPECT_TRUE(ao_->statistics().converged);
    }
    GLint samples = 0; // maybe more than were asked for
    gl_.GetIntegerv(GL_SAMPLES, &samples);
    const FloatImage wanted = expected(camera, samples);
    const FloatImage seen = inner(wanted);
    const FloatImage shown = resolvedColours(camera, kind, target);
    const double found = rmse(shown, seen);
    int darkSky = 0;
    for (std::size_t i = kWidth; i + kWidth < shown.pixels.size(); ++i) {
        const bool sky =
            wanted.pixels[i - kWidth] < 0 && wanted.pixels[i] < 0 && wanted.pixels[i + kWidth] < 0;
        darkSky += sky && shown.pixels[i] < 0.99F ? 1 : 0;
    }
    EXPECT_LT(darkSky, kWidth) << "the background is not the host's";
    gl_.BindFramebuffer(GL_FRAMEBUFFER, 0);
    return found;
}

} // namespace aolib::test
