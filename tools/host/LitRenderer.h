#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <aolib/ProcAddressLoader.h>
#include <aolib/Status.h>
#include <aolib/lighting/EnvironmentLight.h>
#include <aolib/lighting/Sun.h>

#include "gl/GLSLShader.h"
#include "gl/Handle.h"
#include "gl/RenderToTexture2D.h"
#include "host/LitMesh.h"
#include "host/SunDepth.h"
#include "image/Image.h"
#include "scene/Bounds.h"

namespace aolib::host {

/// How surfaces are lit.
enum class LitMethod : std::uint8_t {
    Irradiance,      ///< W times what an open surface sends out
    Blurred,         ///< accessibility times a blurred lookup (GPU Gems, chapter 17)
    BlurredByAngles, ///< the same with the cube map of angles
    Cone,            ///< the cone of open directions
    ConeAndSun,      ///< the same without the sun, which has a shadow map
    Sectors,         ///< how open each of 24 sectors of directions is
    SectorsAndSun,   ///< the same without the sun, which has a shadow map
};

/// Draws a scene under an environment, in linear radiance. Context: the one current at create().
class LitRenderer {
public:
    struct Settings {
        int width = 0;      ///< pixels
        int height = 0;     ///< pixels
        int sunSize = 2048; ///< texels along the sun's depth map
    };

    /// Uploads the scene. @param gl  must outlive the renderer.
    /// Errors: ShaderError, MissingCapability, OutOfMemory.
    static Result<LitRenderer> create(const gl::Functions& gl, const std::vector<LitPiece>& pieces,
                                      const Settings& settings);

    /// Another size of pictures, pixels. Errors: MissingCapability, OutOfMemory.
    AoStatus resize(int width, int height);

    /// Takes an environment. Errors: those of EnvironmentLight::create().
    AoStatus setEnvironment(const ProcAddressLoader& loader, const lighting::EnvironmentMap& map);

    /// Draws a frame: the sun's depth map where the method has one, background, surfaces.
    void draw(const glm::mat4& view, const glm::mat4& projection, LitMethod method);

    /// Radiance, RGB; waits for the GPU. `covered` says where surfaces are, 1 or 0.
    struct Picture {
        FloatImage radiance;
        std::vector<std::uint8_t> covered;
    };
    Picture read() const;

private:
    void drawSky(const glm::mat4& view, const glm::mat4& projection);
    void drawSurfaces(const glm::mat4& view, const glm::mat4& projection, LitMethod method);
    void bindTexture(int unit, GLenum target, TextureName name) const;

    const gl::Functions* gl_ = nullptr;
    gl::GLSLShader surface_;
    gl::GLSLShader sky_;
    gl::VertexArrayName empty_; ///< for the sky, whose vertices need no data
    gl::RenderToTexture2D target_;
    std::optional<SunDepth> sunDepth_;
    std::vector<LitMesh> meshes_;
    Bounds bounds_;
    std::optional<lighting::EnvironmentLight> whole_;
    std::optional<lighting::EnvironmentLight> rest_; ///< without its sun; none where it has none
    std::optional<lighting::Sun> sun_;
};

/// The mean of radiance over all channels of the pixels that show surfaces; 0 where none does.
double meanOverSurfaces(const FloatImage& radiance, const std::vector<std::uint8_t>& covered);

} // namespace aolib::host
