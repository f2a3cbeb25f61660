#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <aolib/Status.h>

#include "bake/gpu/BakeVertices.h"
#include "bake/gpu/LightView.h"
#include "bake/gpu/SlabTriangles.h"
#include "bake/gpu/Slabs.h"
#include "gl/GLSLShader.h"
#include "gl/RenderToTexture2D.h"
#include "gl/VertexArray.h"

namespace aolib::bake {

/// Scattering with a radius: a direction has a picture of each slab. The surface nearest to the
/// light hides all others in its slab, and is lit unless a surface of the slab before lies within
/// the reach. Needs known GL state in each call.
class ScatterSlabs {
public:
    /// The vertices, which keep their triangles, must outlive it. @param rasterSize  pixels along a
    /// picture. Errors: ShaderError, MissingCapability, OutOfMemory.
    static Result<ScatterSlabs> create(const gl::Functions& gl, int rasterSize,
                                       const BakeVertices& vertices);

    /// From now on slabs are those of this direction.
    void begin(const LightView& view);
    int count() const { return slabs_->count(); }
    /// Prepares a slab; call it for one slab after the other. Errors: OutOfMemory.
    AoStatus prepare(int slab);

    bool empty(int slab) const { return triangles_.empty(slab); }
    glm::mat4 toClip(int slab) const { return slabs_->nearest(slab); }
    /// Draws what is farthest from the light in the slab before.
    void drawBefore(int slab);
    /// Draws the slab's triangles, numbered from its first one, and takes away what is hidden by
    /// the slab before: both into what is bound, with the depth test on.
    void draw(gl::GLSLShader& shader, int slab);
    /// The numbers of those in the scene.
    std::span<const std::uint32_t> numbers(int slab) const { return triangles_.numbers(slab); }

private:
    ScatterSlabs(const gl::Functions& gl, const BakeVertices& vertices)
        : gl_(&gl), triangles_(gl, vertices) {}

    const gl::Functions* gl_;
    SlabTriangles triangles_;
    std::optional<Slabs> slabs_;
    int prepared_ = 0; ///< slabs below that are
    gl::GLSLShader depthShader_;
    gl::GLSLShader hideShader_;
    gl::RenderToTexture2D before_;
    gl::VertexArray fullscreen_;
};

} // namespace aolib::bake
