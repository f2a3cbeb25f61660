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

/// Selects the textures of an EnvironmentLight. Since 0.1.
struct EnvironmentLightOptions {
    ConeTableOptions cones;
    bool sectors = false; ///< also make the table of sectors
    bool angles = false;  ///< also make the cube map of angles
    int anglesSize = 256; ///< texels along an edge of that cube map's faces, 1 to 4096
};

/// Textures of an environment for the host's shaders; environmentShader() has the functions that
/// read them. Radiance is stored as 16 bit floats, clamped to 65504.
///
/// Context: OpenGL 3.3. The textures belong to the context that is current at create() and to all
/// contexts that share its objects. GL state is saved and restored.
/// The destructor deletes the textures if one of these contexts is current; otherwise it deletes
/// nothing. Since 0.1.
class EnvironmentLight {
public:
    /// Makes the textures from a map. Context.
    /// Errors: InvalidOption, NoContext, MissingCapability (sizes), OutOfMemory.
    AOLIB_LIGHTING_EXPORT static Result<EnvironmentLight>
    create(const ProcAddressLoader& loader, const EnvironmentMap& map,
           const EnvironmentLightOptions& options = {});

    AOLIB_LIGHTING_EXPORT EnvironmentLight(EnvironmentLight&&) noexcept;
    AOLIB_LIGHTING_EXPORT EnvironmentLight& operator=(EnvironmentLight&&) noexcept;
    AOLIB_LIGHTING_EXPORT ~EnvironmentLight();

    /// GL_TEXTURE_2D_ARRAY: a ConeTable, one layer per aperture. Linear, repeats along u.
    AOLIB_LIGHTING_EXPORT TextureName cones() const;
    /// GL_TEXTURE_2D_ARRAY: a SectorTable, one layer per sector; none unless
    /// `EnvironmentLightOptions::sectors`. Linear, repeats along u. Since 0.1.
    AOLIB_LIGHTING_EXPORT TextureName sectors() const;
    /// GL_TEXTURE_2D: the map itself with mipmaps. Linear, repeats along u.
    AOLIB_LIGHTING_EXPORT TextureName map() const;
    /// GL_TEXTURE_CUBE_MAP: latLong() of each direction in red and green; none unless
    /// `EnvironmentLightOptions::angles`.
    AOLIB_LIGHTING_EXPORT TextureName angles() const;
    /// Returns the GPU memory of all textures, bytes.
    AOLIB_LIGHTING_EXPORT std::size_t bytes() const;

private:
    struct Content;
    explicit EnvironmentLight(std::unique_ptr<Content> content);

    std::unique_ptr<Content> content_;
};

/// Returns GLSL 3.30 functions to insert after the `#version` line of a host's shader:
/// `aoConeLight(cones, normal, bentNormal, visibility)`, `aoSectorLight(sectors, normal, open)`,
/// `aoIrradianceLight`, `aoBlurredLight`, `aoBlurredLightByAngles`, `latLongPlace`;
/// shaders/lighting/environment.glsl describes them.
AOLIB_LIGHTING_EXPORT std::string_view environmentShader();

} // namespace aolib::lighting
