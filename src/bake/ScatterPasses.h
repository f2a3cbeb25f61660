#pragma once

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

/// The maps that one target holds, one above the other.
struct MapStack {
    glm::ivec2 mapSize{0}; ///< texels
    int first = 0;         ///< number of the lowest
    int count = 0;
};

/// The GL side of scattering: stages 1 and 2 (McGraw and Sowers 2008, section 3). Needs a clean
/// slate of GL state in each call.
class ScatterPasses {
public:
    struct Settings {
        MapStack stack;
        int rasterSize = 0;     ///< pixels along stage 1's picture
        float pointSize = 0.0F; ///< texels
        float density = 0.0F;   ///< square texels per square frame unit; 0: by the Jacobian
        glm::vec4 ground{0.0F}; ///< up and height in the frame; up 0 for none
    };

    /// A picture's side, frame units: it just holds the scene, whose bounding sphere's diameter is
    /// 2; most directions show less of a box.
    static constexpr float pictureSide = 1.6F;

    ScatterPasses() = default;
    /// @param facets  per texel of the stack, from the bottom. Errors: ShaderError,
    /// MissingCapability, OutOfMemory.
    static Result<ScatterPasses> create(const gl::Functions& gl, const Settings& settings,
                                        const std::vector<float>& facets);

    /// Sums what of each texel charts cover, spread as points are: adds places `first` to `last` -
    /// 1 of `count` in each texel.
    void addCoverage(const BakeVertices& vertices, int first, int last, int count);
    /// Sums the light of one direction.
    void addDirection(const BakeVertices& vertices, const LightView& view);

    /// Per texel of the stack, from the bottom: weighed direction and weight.
    std::vector<glm::vec4> sums() const { return read(sums_); }
    /// Per texel of the stack: the covered share in the last component.
    std::vector<glm::vec4> coverage() const { return read(coverage_); }

private:
    void setStack(gl::GLSLShader& shader) const;
    void clear(const gl::RenderToTexture2D& target) const;
    void clearSurface() const;
    void scatter(const gl::RenderToTexture2D& target, const glm::vec3& direction,
                 const glm::ivec2& size);
    std::vector<glm::vec4> read(const gl::RenderToTexture2D& target) const;

    const gl::Functions* gl_ = nullptr;
    Settings settings_;
    gl::GLSLShader surfaceShader_;
    gl::GLSLShader chartShader_;
    gl::GLSLShader pointShader_;
    gl::RenderToTexture2D surface_;
    gl::RenderToTexture2D sums_;
    gl::RenderToTexture2D coverage_;
    gl::TextureStack facets_;
    gl::VertexArray points_;
};

} // namespace aolib::bake
