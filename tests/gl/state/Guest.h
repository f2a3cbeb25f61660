#pragma once

#include <optional>
#include <string>
#include <vector>

#include <aolib/aolib.h>

#include "Dice.h"
#include "HostileRenderer.h"
#include "content/Model.h"

namespace aolib {

/// Small and quick: what the tests of this folder ask of aolib.
Options smallOptions();
/// A floor, two boxes on it, 20 units across.
Model guestScene();

/// aolib as a careless host uses it: makes any public call at any time, and knows what each must
/// answer.
class Guest {
public:
    static const glm::mat4& view();
    static const glm::mat4& projection();
    static const glm::vec3& eye();

    /// What the host's state lets aolib answer.
    struct Situation {
        StatusCode frame = StatusCode::Ok; ///< of aoDrawEnd()
        StatusCode apply = StatusCode::Ok; ///< of aoApply()
        bool compatibility = false;
    };

    /// @param gl  the host's own functions, for textures that it hands over.
    Guest(const ProcAddressLoader& loader, const gl::Functions& gl);

    /// One public call, or a few that belong together.
    /// @return its name, with what it answered if that was not what it must answer.
    struct Outcome {
        std::string call;
        std::string fault;
    };
    Outcome call(Dice& dice, const Situation& situation);
    static std::size_t kinds();
    /// Pixels that were computed for views at rest so far.
    std::size_t pixelsAtRest() const { return pixelsAtRest_; }

private:
    friend struct GuestCalls;

    void makeTextures(const gl::Functions& gl);

    const ProcAddressLoader& loader_;
    std::vector<gl::Texture> textures_; ///< depth, colour, normal
    HostileRenderer hostile_;
    std::optional<AmbientOcclusion> ao_;    ///< has a scene and a camera
    std::optional<AmbientOcclusion> empty_; ///< has neither
    std::optional<AmbientOcclusion> drawn_; ///< has a camera, and a scene renderer
    bool throws_ = false;                   ///< that renderer does
    std::vector<MeshId> meshes_;
    bool hadFrame_ = false;
    std::size_t pixelsAtRest_ = 0;
};

} // namespace aolib
