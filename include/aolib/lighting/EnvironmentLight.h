#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include <aolib/HostTextures.h>
#include <aolib/LightingExport.h>
#include <aolib/ProcAddressLoader.h>
#include <aolib/Status.h>
#include <aolib/lighting/ConeTable.h>
#include <aolib/lighting/EnvironmentMap.h>
#include <aolib/lighting/SectorTable.h>

namespace aolib::lighting {

/// What an EnvironmentLight makes. Since 0.1.
struct EnvironmentLightOptions {
    ConeTableOptions cones;
    bool sectors = false; ///< also the table of sectors
    bool angles = false;  ///< also the cube map of angles
    int anglesSize = 256; ///< texels along its faces, 1 to 4096
};

/// An environment in a context's textures, for a host's own shaders, which environmentShader()
/// gives the functions for. Radiance is kept as 16 bit floats: above 65504 it is cut.
///
/// Context: its textures belong to the one that was current at create() and to all that share its
/// objects, one of which must be current when it goes. Elsewhere, or without a context, it touches
/// no object when it goes. Needs OpenGL 3.3. GL state is saved and restored. Since 0.1.
class EnvironmentLight {
public:
    /// Errors: InvalidOption, NoContext, MissingCapability (sizes), OutOfMemory.
    AOLIB_LIGHTING_EXPORT static Result<EnvironmentLight>
    create(const ProcAddressLoader& loader, const EnvironmentMap& map,
           const EnvironmentLightOptions& options = {});

    AOLIB_LIGHTING_EXPORT EnvironmentLight(EnvironmentLight&&) noexcept;
    AOLIB_LIGHTING_EXPORT EnvironmentLight& operator=(EnvironmentLight&&) noexcept;
    AOLIB_LIGHTING_EXPORT ~EnvironmentLight();

    /// GL_TEXTURE_2D_ARRAY: a ConeTable, one layer an aperture. Linear, repeats along u.
    AOLIB_LIGHTING_EXPORT TextureName cones() const;
    /// GL_TEXTURE_2D_ARRAY: a SectorTable, one layer a sector; none where not asked for. Linear,
    /// repeats along u. Since 0.1.
    AOLIB_LIGHTING_EXPORT TextureName sectors() const;
    /// GL_TEXTURE_2D: the map itself with mipmaps. Linear, repeats along u.
    AOLIB_LIGHTING_EXPORT TextureName map() const;
    /// GL_TEXTURE_CUBE_MAP: latLong() of each direction in red and green; none where not asked for.
    AOLIB_LIGHTING_EXPORT TextureName angles() const;
    /// GPU memory of all of them.
    AOLIB_LIGHTING_EXPORT std::size_t bytes() const;

private:
    struct Content;
    explicit EnvironmentLight(std::unique_ptr<Content> content);

    std::unique_ptr<Content> content_;
};

/// Functions in GLSL 3.30 to put before a host's own, behind its `#version` line:
/// `aoConeLight(cones, normal, bentNormal, visibility)`, `aoSectorLight(sectors, normal, open)`,
/// `aoIrradianceLight`, `aoBlurredLight`, `aoBlurredLightByAngles`, `latLongPlace`;
/// shaders/lighting/environment.glsl describes them.
AOLIB_LIGHTING_EXPORT std::string_view environmentShader();

} // namespace aolib::lighting
