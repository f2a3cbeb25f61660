#include "lighting/LightTexture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "gl/Label.h"
#include "lighting/Reduced.h"

namespace aolib::lighting {

namespace {

constexpr float greatestHalf = 65504.0F;
constexpr std::size_t bytesOfHalves = 6;

std::vector<glm::vec3> cut(const std::vector<glm::vec3>& radiance) {
    std::vector<glm::vec3> result(radiance.size());
    std::transform(radiance.begin(), radiance.end(), result.begin(),
                   [](const glm::vec3& value) { return glm::min(value, glm::vec3(greatestHalf)); });
    return result;
}

Result<LightTexture> named(const gl::Functions& gl, GLenum target, const std::string& label) {
    LightTexture made{gl::generate<gl::Texture>(gl, &gl::Functions::GenTextures), 0};
    if (!made.texture) {
        return AoStatus(StatusCode::OutOfMemory, label + ": GL gave no name");
    }
    gl.ActiveTexture(GL_TEXTURE0);
    gl.BindTexture(target, made.texture.name());
    gl::label(gl, GL_TEXTURE, made.texture.name(), label);
    return made;
}

void setSampling(const gl::Functions& gl, GLenum target, GLint minFilter, GLint lastLevel) {
    gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, lastLevel);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_S, GL_REPEAT);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, minFilter);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

/// Whether GL had memory for a level, or for a cube map's face.
AoStatus checkWidth(const gl::Functions& gl, GLenum target, int level, int wanted,
                    const std::string& label) {
    GLint width = 0;
    gl.GetTexLevelParameteriv(target, level, GL_TEXTURE_WIDTH, &width);
    if (width != wanted) {
        return {StatusCode::OutOfMemory, label + ": no memory for its texels"};
    }
    return {};
}

/// The direction of a texel of GL's cube maps (GL 3.3, table 3.10).
glm::vec3 cubeTexelDirection(int face, const glm::vec2& at) {
    const glm::vec2 p = 2.0F * at - 1.0F;
    switch (face) {
    case 0:
        return {1.0F, -p.y, -p.x};
    case 1:
        return {-1.0F, -p.y, p.x};
    case 2:
        return {p.x, 1.0F, p.y};
    case 3:
        return {p.x, -1.0F, -p.y};
    case 4:
        return {p.x, -p.y, 1.0F};
    default:
        return {-p.x, -p.y, -1.0F};
    }
}

AoStatus tooLarge(const std::string& label, int width, int height, int limit) {
    return {StatusCode::MissingCapability,
            label + " has " + std::to_string(width) + " x " + std::to_string(height) +
                " texels; this context allows " + std::to_string(limit)};
}

/// GL_TEXTURE_2D_ARRAY of halves, which repeats along u.
Result<LightTexture> uploadLayers(const gl::Functions& gl, const std::string& label,
                                  const glm::ivec3& size, const std::vector<glm::vec3>& values) {
    const int limit = gl.capabilities.maxTextureSize;
    if (size.x > limit || size.y > limit || size.z > gl.capabilities.maxTextureLayers) {
        return tooLarge(label, size.x, size.y, limit);
    }
    Result<LightTexture> made = named(gl, GL_TEXTURE_2D_ARRAY, label);
    if (!made) {
        return made;
    }
    gl.TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGB16F, size.x, size.y, size.z, 0, GL_RGB, GL_FLOAT,
                  cut(values).data());
    setSampling(gl, GL_TEXTURE_2D_ARRAY, GL_LINEAR, 0);
    made->bytes = values.size() * bytesOfHalves;
    if (AoStatus status = checkWidth(gl, GL_TEXTURE_2D_ARRAY, 0, size.x, label); !status) {
        return status;
    }
    return made;
}

} // namespace

Result<LightTexture> uploadCones(const gl::Functions& gl, const ConeTable& cones) {
    const ConeTableOptions& size = cones.size();
    return uploadLayers(gl, "aolib/environment/cones", {size.columns, size.rows, size.apertures},
                        cones.values());
}

Result<LightTexture> uploadSectors(const gl::Functions& gl, const SectorTable& sectors) {
    const SectorTableOptions& size = sectors.size();
    return uploadLayers(gl, "aolib/environment/sectors",
                        {size.columns, size.rows, std::tuple_size_v<OpenSectors>},
                        sectors.values());
}

Result<LightTexture> uploadMap(const gl::Functions& gl, const EnvironmentMap& map) {
    const std::string label = "aolib/environment/map";
    const int limit = gl.capabilities.maxTextureSize;
    if (map.width > limit || map.height > limit) {
        return tooLarge(label, map.width, map.height, limit);
    }
    Result<LightTexture> made = named(gl, GL_TEXTURE_2D, label);
    if (!made) {
        return made;
    }
    EnvironmentMap level = map;
    int number = 0;
    for (;; ++number) {
        const std::vector<glm::vec3> values = cut(level.radiance);
        gl.TexImage2D(GL_TEXTURE_2D, number, GL_RGB16F, level.width, level.height, 0, GL_RGB,
                      GL_FLOAT, values.data());
        if (AoStatus status = checkWidth(gl, GL_TEXTURE_2D, number, level.width, label); !status) {
            return status;
        }
        made->bytes += values.size() * bytesOfHalves;
        if (level.width == 1 && level.height == 1) {
            break;
        }
        level = halved(level);
    }
    setSampling(gl, GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, number);
    return made;
}

Result<LightTexture> uploadAngles(const gl::Functions& gl, int size) {
    const std::string label = "aolib/environment/angles";
    gl.ActiveTexture(GL_TEXTURE0);
    GLint bound = 0;
    gl.GetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP, &bound);
    Result<LightTexture> made = named(gl, GL_TEXTURE_CUBE_MAP, label);
    if (!made) {
        return made;
    }
    std::vector<std::uint8_t> texels(2U * static_cast<std::size_t>(size) *
                                     static_cast<std::size_t>(size));
    AoStatus status;
    for (int face = 0; face < 6 && status; ++face) {
        std::size_t texel = 0;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const glm::vec2 at{(static_cast<float>(x) + 0.5F) / static_cast<float>(size),
                                   (static_cast<float>(y) + 0.5F) / static_cast<float>(size)};
                const glm::vec2 place = latLong(cubeTexelDirection(face, at));
                texels[texel++] = static_cast<std::uint8_t>(std::lround(255.0F * place.x));
                texels[texel++] = static_cast<std::uint8_t>(std::lround(255.0F * place.y));
            }
        }
        const GLenum target = GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face);
        gl.TexImage2D(target, 0, GL_RG8, size, size, 0, GL_RG, GL_UNSIGNED_BYTE, texels.data());
        status = checkWidth(gl, target, 0, size, label);
    }
    setSampling(gl, GL_TEXTURE_CUBE_MAP, GL_NEAREST, 0);
    gl.TexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.BindTexture(GL_TEXTURE_CUBE_MAP, static_cast<GLuint>(bound));
    if (!status) {
        return status;
    }
    made->bytes = 6 * texels.size();
    return made;
}

} // namespace aolib::lighting
