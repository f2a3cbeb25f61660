#include "host/LitRenderer.h"

#include <algorithm>
#include <string>
#include <utility>

#include <glm/matrix.hpp>

#include "host/HostShaders.h"

namespace aolib::host {

namespace {

constexpr int kConesUnit = 0;
constexpr int kMapUnit = 1;
constexpr int kAnglesUnit = 2;
constexpr int kSunUnit = 3;
constexpr int kSectorsUnit = 4;

bool drawsSun(LitMethod method) {
    return method == LitMethod::ConeAndSun || method == LitMethod::SectorsAndSun;
}

/// The number that lit.frag knows a method by.
int shaderMethod(LitMethod method) {
    switch (method) {
    case LitMethod::ConeAndSun:
        return static_cast<int>(LitMethod::Cone);
    case LitMethod::SectorsAndSun:
        return static_cast<int>(LitMethod::Sectors);
    default:
        return static_cast<int>(method);
    }
}

Result<gl::GLSLShader> build(const gl::Functions& gl, const gl::GLSLShader::Source& vertex,
                             const gl::GLSLShader::Source& fragment) {
    const std::string text = "#version 330 core\n" + std::string(lighting::environmentShader()) +
                             std::string(fragment.text);
    return gl::GLSLShader::build(gl, vertex, {fragment.name, text});
}

} // namespace

Result<LitRenderer> LitRenderer::create(const gl::Functions& gl,
                                        const std::vector<LitPiece>& pieces,
                                        const Settings& settings) {
    LitRenderer renderer;
    renderer.gl_ = &gl;
    Result<gl::GLSLShader> surface =
        build(gl, {"lit.vert", litVertexShader}, {"lit.frag", litFragmentShader});
    if (!surface) {
        return surface.status();
    }
    renderer.surface_ = std::move(*surface);
    Result<gl::GLSLShader> sky =
        build(gl, {"sky.vert", skyVertexShader}, {"lit_sky.frag", litSkyFragmentShader});
    if (!sky) {
        return sky.status();
    }
    renderer.sky_ = std::move(*sky);
    renderer.empty_ = gl::generate<gl::VertexArrayName>(gl, &gl::Functions::GenVertexArrays);
    if (AoStatus status = renderer.resize(settings.width, settings.height); !status) {
        return status;
    }
    Result<SunDepth> sun = SunDepth::create(gl, settings.sunSize);
    if (!sun) {
        return sun.status();
    }
    renderer.sunDepth_ = std::move(*sun);
    for (const LitPiece& piece : pieces) {
        Result<LitMesh> mesh = LitMesh::create(gl, piece);
        if (!mesh) {
            return mesh.status();
        }
        renderer.meshes_.push_back(std::move(*mesh));
        for (const glm::vec3& position : piece.positions) {
            renderer.bounds_.include(position);
        }
    }
    return renderer;
}

AoStatus LitRenderer::resize(int width, int height) {
    if (width == target_.width() && height == target_.height()) {
        return {};
    }
    gl::RenderToTexture2D::Settings target;
    target.width = width;
    target.height = height;
    target.targets = {gl::RenderToTexture2D::Format::RGBA32F};
    target.depth = gl::RenderToTexture2D::Depth::Depth32F;
    target.label = "host/lit";
    Result<gl::RenderToTexture2D> made = gl::RenderToTexture2D::create(*gl_, target);
    if (made) {
        target_ = std::move(*made);
    }
    return made.status();
}

AoStatus LitRenderer::setEnvironment(const ProcAddressLoader& loader,
                                     const lighting::EnvironmentMap& map) {
    lighting::EnvironmentLightOptions options;
    options.angles = true;
    options.sectors = true;
    Result<lighting::EnvironmentLight> whole =
        lighting::EnvironmentLight::create(loader, map, options);
    if (!whole) {
        return whole.status();
    }
    whole_ = std::move(*whole);
    lighting::SplitEnvironment split = lighting::splitSun(map);
    sun_ = split.sun;
    rest_.reset();
    lighting::EnvironmentLightOptions sectorsToo;
    sectorsToo.sectors = true;
    if (sun_) {
        Result<lighting::EnvironmentLight> rest =
            lighting::EnvironmentLight::create(loader, split.rest, sectorsToo);
        if (!rest) {
            return rest.status();
        }
        rest_ = std::move(*rest);
    }
    return {};
}

void LitRenderer::draw(const glm::mat4& view, const glm::mat4& projection, LitMethod method) {
    gl_->Disable(GL_BLEND);
    gl_->Disable(GL_CULL_FACE);
    gl_->Disable(GL_SCISSOR_TEST);
    gl_->Disable(GL_STENCIL_TEST);
    gl_->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    if (drawsSun(method) && sun_) {
        sunDepth_->draw(meshes_, bounds_, sun_->direction);
    }
    target_.bindAllAsTargets();
    drawSky(view, projection);
    drawSurfaces(view, projection, method);
    gl_->BindVertexArray(0);
    gl_->UseProgram(0);
}

void LitRenderer::bindTexture(int unit, GLenum target, TextureName name) const {
    gl_->ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl_->BindTexture(target, static_cast<GLuint>(name));
}

void LitRenderer::drawSky(const glm::mat4& view, const glm::mat4& projection) {
    gl_->Disable(GL_DEPTH_TEST);
    bindTexture(kMapUnit, GL_TEXTURE_2D, whole_->map());
    sky_.bind();
    sky_.set("environment", kMapUnit);
    sky_.set("inverseProjection", glm::inverse(projection));
    sky_.set("eyeToWorld", glm::inverse(glm::mat3(view)));
    gl_->BindVertexArray(empty_.name());
    gl_->DrawArrays(GL_TRIANGLES, 0, 3);
}

void LitRenderer::drawSurfaces(const glm::mat4& view, const glm::mat4& projection,
                               LitMethod method) {
    const bool withSun = drawsSun(method) && sun_.has_value();
    const lighting::EnvironmentLight& light = withSun ? *rest_ : *whole_;
    bindTexture(kConesUnit, GL_TEXTURE_2D_ARRAY, light.cones());
    bindTexture(kMapUnit, GL_TEXTURE_2D, light.map());
    bindTexture(kAnglesUnit, GL_TEXTURE_CUBE_MAP, whole_->angles());
    bindTexture(kSectorsUnit, GL_TEXTURE_2D_ARRAY, light.sectors());
    sunDepth_->bind(kSunUnit);
    gl_->Enable(GL_DEPTH_TEST);
    gl_->DepthFunc(GL_LESS);
    gl_->DepthMask(GL_TRUE);
    const float far = 1.0F;
    gl_->ClearBufferfv(GL_DEPTH, 0, &far);
    surface_.bind();
    surface_.set("viewProjection", projection * view);
    surface_.set("eyePosition", glm::vec3(glm::inverse(view)[3]));
    surface_.set("method", shaderMethod(method));
    surface_.set("cones", kConesUnit);
    surface_.set("sectors", kSectorsUnit);
    surface_.set("environment", kMapUnit);
    surface_.set("angles", kAnglesUnit);
    surface_.set("sunDepth", kSunUnit);
    surface_.set("sunIrradiance", withSun ? sun_->irradiance : glm::vec3(0.0F));
    surface_.set("sunDirection", withSun ? sun_->direction : glm::vec3(0.0F, 1.0F, 0.0F));
    surface_.set("worldToLight", sunDepth_->worldToMap());
    surface_.set("sunTexel", sunDepth_->texel());
    for (const LitMesh& mesh : meshes_) {
        surface_.set("baseColour", mesh.colour());
        mesh.draw();
    }
}

LitRenderer::Picture LitRenderer::read() const {
    FloatImage all(target_.width(), target_.height(), 4);
    target_.bindForReading(0);
    gl_->BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    gl_->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl_->ReadPixels(0, 0, all.width, all.height, GL_RGBA, GL_FLOAT, all.pixels.data());
    Picture picture{FloatImage(all.width, all.height, 3), {}};
    for (std::size_t pixel = 0; pixel < all.pixelCount(); ++pixel) {
        std::copy_n(all.pixels.begin() + static_cast<std::ptrdiff_t>(4 * pixel), 3,
                    picture.radiance.pixels.begin() + static_cast<std::ptrdiff_t>(3 * pixel));
        picture.covered.push_back(all.pixels[4 * pixel + 3] > 0.5F ? 1 : 0);
    }
    return picture;
}

double meanOverSurfaces(const FloatImage& radiance, const std::vector<std::uint8_t>& covered) {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t pixel = 0; pixel < covered.size(); ++pixel) {
        if (covered[pixel] != 0) {
            for (std::size_t channel = 0; channel < 3; ++channel) {
                sum += double{radiance.pixels[3 * pixel + channel]} / 3.0;
            }
            count += 1.0;
        }
    }
    return count > 0.0 ? sum / count : 0.0;
}

} // namespace aolib::host
