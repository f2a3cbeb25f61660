#include <aolib/lighting/EnvironmentLight.h>

#include <new>
#include <utility>

#include "gl/ContextGroup.h"
#include "gl/StateGuard.h"
#include "lighting/LightTexture.h"

namespace aolib::lighting {

struct EnvironmentLight::Content {
    explicit Content(const gl::Functions& functions) : gl(functions) { gl.group = &contexts; }
    ~Content() { contexts.enterToDelete(); }
    Content(const Content&) = delete;
    Content& operator=(const Content&) = delete;

    gl::Functions gl; ///< before the textures, which refer to it
    gl::ContextGroup contexts{gl};
    LightTexture cones;
    LightTexture sectors;
    LightTexture map;
    LightTexture angles;
};

EnvironmentLight::EnvironmentLight(std::unique_ptr<Content> content)
    : content_(std::move(content)) {}
EnvironmentLight::EnvironmentLight(EnvironmentLight&&) noexcept = default;
EnvironmentLight& EnvironmentLight::operator=(EnvironmentLight&&) noexcept = default;
EnvironmentLight::~EnvironmentLight() = default;

Result<EnvironmentLight> EnvironmentLight::create(const ProcAddressLoader& loader,
                                                  const EnvironmentMap& map,
                                                  const EnvironmentLightOptions& options) {
    if (options.angles && (options.anglesSize < 1 || options.anglesSize > 4096)) {
        return AoStatus(StatusCode::InvalidOption, "anglesSize is " +
                                                       std::to_string(options.anglesSize) +
                                                       ", must be 1 to 4096");
    }
    try {
        const Result<ConeTable> cones = ConeTable::create(map, options.cones);
        if (!cones) {
            return cones.status();
        }
        const Result<gl::Functions> functions = gl::Functions::load(loader);
        if (!functions) {
            return functions.status();
        }
        auto content = std::make_unique<Content>(*functions);
        if (AoStatus status = content->contexts.found(); !status) {
            return status;
        }
        const gl::ContextScope scope(content->contexts);
        if (!scope.status()) {
            return scope.status();
        }
        const gl::StateGuard guard(content->gl);
        const auto put = [](Result<LightTexture> made, LightTexture& texture) {
            if (made) {
                texture = std::move(*made);
            }
            return made.status();
        };
        if (AoStatus status = put(uploadCones(content->gl, *cones), content->cones); !status) {
            return status;
        }
        if (options.sectors) {
            const Result<SectorTable> sectors = SectorTable::create(map);
            if (!sectors) {
                return sectors.status();
            }
            if (AoStatus status = put(uploadSectors(content->gl, *sectors), content->sectors);
                !status) {
                return status;
            }
        }
        if (AoStatus status = put(uploadMap(content->gl, map), content->map); !status) {
            return status;
        }
        if (options.angles) {
            if (AoStatus status =
                    put(uploadAngles(content->gl, options.anglesSize), content->angles);
                !status) {
                return status;
            }
        }
        return EnvironmentLight(std::move(content));
    } catch (const std::bad_alloc&) {
        return AoStatus(StatusCode::OutOfMemory, "no memory left for the environment");
    }
}

TextureName EnvironmentLight::cones() const {
    return TextureName{content_->cones.texture.name()};
}

TextureName EnvironmentLight::sectors() const {
    return TextureName{content_->sectors.texture.name()};
}

TextureName EnvironmentLight::map() const {
    return TextureName{content_->map.texture.name()};
}

TextureName EnvironmentLight::angles() const {
    return TextureName{content_->angles.texture.name()};
}

std::size_t EnvironmentLight::bytes() const {
    return content_->cones.bytes + content_->sectors.bytes + content_->map.bytes +
           content_->angles.bytes;
}

} // namespace aolib::lighting
