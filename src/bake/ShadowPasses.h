#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <aolib/Status.h>
#include <aolib/bake/BakeOptions.h>

#include "bake/BakeVertices.h"
#include "bake/LightView.h"
#include "gl/GLSLShader.h"
#include "gl/RenderToTexture2D.h"
#include "gl/TextureStack.h"
#include "gl/VertexArray.h"

namespace aolib::bake {

/// The GL side of shadow-map occlusion (GPU Gems, chapter 17.3): depth maps, several side by side,
/// then one pass over all receivers. Needs a clean slate of GL state in each call.
class ShadowPasses {
public:
    struct Settings {
        glm::ivec2 size{0};     ///< of the grid of receivers, texels
        int depthSize = 0;      ///< texels along a depth map
        int mapsPerPass = 0;    ///< made less where no texture holds so many
        float bias = 0.0F;      ///< texels of a depth map, times the slope
        glm::vec4 ground{0.0F}; ///< up and height in the frame; up 0 for none
    };

    ShadowPasses() = default;
    /// Errors: ShaderError, MissingCapability, OutOfMemory.
    static Result<ShadowPasses> create(const gl::Functions& gl, const Settings& settings);

    /// Begins new sums: of what the next directions light.
    /// @param receivers  row by row; nothing where there is none.
    void begin(const BakeFrame& frame, std::span<const std::optional<SurfacePoint>> receivers);

    int mapsPerPass() const { return settings_.mapsPerPass; }
    int depthSize() const { return settings_.depthSize; }
    /// Draws the depth maps of up to mapsPerPass() directions and adds what they light.
    void addDirections(const BakeVertices& vertices, std::span<const LightView> views);
    /// Per receiver: weighed direction and weight.
    std::vector<glm::vec4> sums() const;

private:
    void drawDepths(const BakeVertices& vertices, std::span<const LightView> views);
    void gather(std::span<const LightView> views);
    glm::ivec2 tile(std::size_t number) const;

    const gl::Functions* gl_ = nullptr;
    Settings settings_;
    glm::ivec2 tiles_{0}; ///< depth maps beside and above each other
    gl::GLSLShader depthShader_;
    gl::GLSLShader gatherShader_;
    gl::RenderToTexture2D depths_;
    gl::RenderToTexture2D sums_;
    gl::TextureStack receivers_;
    gl::VertexArray fullscreen_;
};

} // namespace aolib::bake
