#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <aolib/Status.h>
#include <aolib/bake/BakeOptions.h>

#include "bake/gpu/BakeVertices.h"
#include "bake/gpu/LightView.h"
#include "bake/scatter/MapStack.h"
#include "bake/scatter/ScatterSlabs.h"
#include "gl/GLSLShader.h"
#include "gl/RenderToTexture2D.h"
#include "gl/TextureStack.h"
#include "gl/VertexArray.h"

namespace aolib::bake {

/// The GL side of scattering: stages 1 and 2 (McGraw and Sowers 2008, section 3). Needs known GL
/// state in each call.
class ScatterPasses {
public:
    struct Settings {
        MapStack stack;
        int rasterSize = 0;     ///< pixels along stage 1's picture
        float pointSize = 0.0F; ///< texels
        float density = 0.0F;   ///< square texels per square frame unit; 0: by the Jacobian
        glm::vec4 ground{0.0F}; ///< up and height in the frame; up 0 for none
        bool draws = true;      ///< points are drawn and blended; else the picture is read back
        bool places = false;    ///< the picture holds positions in the frame, not in the map
        bool slabs = false;     ///< occluders have an end; the vertices keep their triangles
    };

    /// A picture's side, frame units: it just holds the scene, whose bounding sphere's diameter is
    /// 2; most directions show less of a box.
    static constexpr float pictureSide = 1.6F;

    ScatterPasses() = default;
    /// The vertices must outlive it.
    /// @param facets  per texel of the stack, from the bottom. Errors: ShaderError,
    /// MissingCapability, OutOfMemory.
    static Result<ScatterPasses> create(const gl::Functions& gl, const Settings& settings,
                                        const BakeVertices& vertices,
                                        std::span<const float> facets);

    /// Stage 1: what one direction lights, in one picture, or in one for each of its slabs.
    /// @param take  is called for each, for stage 2. Errors: OutOfMemory.
    AoStatus drawSurface(const LightView& view, const std::function<void()>& take);
    /// Stage 2, where points are drawn: adds it to the sums.
    void scatter(const LightView& view);
    /// Stage 1's picture: u, v, number of the triangle from 1, 0 for none; or with `places` x, y,
    /// z, number. Where points are not drawn.
    const std::vector<glm::vec4>& readSurface();

    /// Per texel of the stack, from the bottom: weighed direction and weight. Where points are
    /// drawn.
    std::vector<glm::vec4> sums() const;

private:
    void clearSurface() const;
    void beginSurface(const LightView& view, const glm::mat4& toClip);
    AoStatus drawSlabs(const LightView& view, const std::function<void()>& take);

    const gl::Functions* gl_ = nullptr;
    const BakeVertices* vertices_ = nullptr;
    Settings settings_;
    gl::GLSLShader surfaceShader_;
    gl::GLSLShader pointShader_;
    gl::RenderToTexture2D surface_;
    gl::RenderToTexture2D sums_;
    gl::TextureStack facets_;
    gl::VertexArray points_;
    std::vector<glm::vec4> picture_;
    std::optional<ScatterSlabs> slabs_;
    int slab_ = 0; ///< that the picture shows
};

} // namespace aolib::bake
