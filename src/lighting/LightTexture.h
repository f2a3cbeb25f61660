#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <aolib/Status.h>
#include <aolib/lighting/ConeTable.h>
#include <aolib/lighting/EnvironmentMap.h>
#include <aolib/lighting/SectorTable.h>

#include "gl/Handle.h"

namespace aolib::lighting {

/// A texture that is filled once, and what it takes of GPU memory. Made on texture unit 0, within
/// a StateGuard.
struct LightTexture {
    gl::Texture texture;
    std::size_t bytes = 0;
};

/// GL_TEXTURE_2D_ARRAY of a cone table. Errors: MissingCapability, OutOfMemory.
Result<LightTexture> uploadCones(const gl::Functions& gl, const ConeTable& cones);

/// GL_TEXTURE_2D_ARRAY of a sector table. Errors: MissingCapability, OutOfMemory.
Result<LightTexture> uploadSectors(const gl::Functions& gl, const SectorTable& sectors);

/// GL_TEXTURE_2D of a map with all its mipmaps, each texel the mean of those it stands for.
/// Errors: MissingCapability, OutOfMemory.
Result<LightTexture> uploadMap(const gl::Functions& gl, const EnvironmentMap& map);

/// GL_TEXTURE_CUBE_MAP of latLong() in 8 bit, as the seed of the method has it. Nearest: between
/// the two ends of a turn there is nothing to interpolate. Puts back what was bound.
/// Errors: OutOfMemory.
Result<LightTexture> uploadAngles(const gl::Functions& gl, int size);

} // namespace aolib::lighting
