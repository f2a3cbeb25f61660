#pragma once

#include <memory>
#include <optional>

#include <glm/mat4x4.hpp>

#include <aolib/lighting/EnvironmentMap.h>

#include "app/GlSession.h"
#include "bench/environment/LitScene.h"
#include "host/HostFramebuffer.h"
#include "host/LitRenderer.h"
#include "viewer/TracedPicture.h"

namespace aolib::viewer {

/// What a scene is lit by, and what that needs to be known of it.
struct Light {
    std::shared_ptr<const bench::LitScene> scene;                ///< null until it is baked
    std::shared_ptr<const lighting::EnvironmentMap> environment; ///< null for none
    float turn = 0.0F;                                           ///< about +Y, degrees
    float stops = 0.0F; ///< of exposure, above what the first picture of this light would get

    bool operator==(const Light&) const = default;
    bool ready() const { return scene && environment; }
};

/// The scene by the light of an environment, drawn as `aolib render --environment` draws it, by
/// sectors with the sun apart. Context: the window's, for every call.
class LitPicture {
public:
    /// @param light  ready. @param painter  puts the picture into the target.
    /// Errors: those of LitRenderer and of EnvironmentLight.
    AoStatus draw(const app::GlSession& session, const Light& light, const glm::mat4& view,
                  const glm::mat4& projection, const host::HostFramebuffer& target,
                  TracedPicture& painter);

private:
    AoStatus prepare(const app::GlSession& session, const Light& light, const glm::ivec2& pixels);

    std::optional<host::LitRenderer> renderer_;
    Light drawn_;
    float exposure_ = 0.0F; ///< without stops; 0 until surfaces were seen
};

} // namespace aolib::viewer
