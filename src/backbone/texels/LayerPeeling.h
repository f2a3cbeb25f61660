#pragma once

#include <vector>

#include "backbone/texels/FaceCapture.h"
#include "gl/RenderToTexture2D.h"

namespace aolib {

/// The passes over one face of a cube map that find layers of solid intervals [entry, exit] along
/// each texel's ray, nearest first.
///
/// One-sided shells are open meshes of which only one side is visible, such as walls and hulls. The
/// space behind that side, up to the next surface, is hidden and counts as solid.
/// Two-sided sheets are open meshes that show both sides, such as leaves and cloth. These have no
/// thickness.
class LayerPeeling {
public:
    /// Solids that may contain a cube's centre, as shaders/cubemap/peel.glsl has room for.
    static constexpr std::size_t kMostEnclosing = 16;
    /// Open meshes that are no one-sided shells, as shaders/cubemap/peel.vert has room for.
    static constexpr std::size_t kMostUnusual = 128;

    /// What the passes read of the whole scene.
    struct Marks {
        std::vector<float> around; ///< solids that contain the cube's centre
        std::vector<float>
            unusual; ///< open meshes that are no one-sided shells; negative where only backs show
    };

    /// Errors: ShaderError.
    static Result<LayerPeeling> create(const BackboneContext& context);

    /// The side that each ray's nearest surface shows, as cubemap/peel_sides.frag says.
    /// @return whether anything was drawn.
    bool drawSides(const FaceCapture& faces, int face, const gl::RenderToTexture2D& sides);
    /// How many intervals begin along each ray.
    void drawCounts(const FaceCapture& faces, int face, const Marks& marks,
                    const gl::RenderToTexture2D& counts);
    /// The next surface behind a layer and its exits; the first one without.
    void peelEntries(const FaceCapture& faces, int face, const Marks& marks,
                     const gl::RenderToTexture2D* previous, const gl::RenderToTexture2D& exits,
                     const gl::RenderToTexture2D& entries);
    /// Where the solids that are entered end.
    void peelExits(const FaceCapture& faces, int face, const Marks& marks,
                   const gl::RenderToTexture2D& entries, const gl::RenderToTexture2D& exits);
    /// Both as a layer of intervals, to the target that is bound.
    void pack(const BackboneContext& context, const gl::RenderToTexture2D& entries,
              const gl::RenderToTexture2D& exits);

private:
    gl::GLSLShader sides_;
    gl::GLSLShader count_;
    gl::GLSLShader entry_;
    gl::GLSLShader exit_;
    gl::GLSLShader pack_;
    const gl::Functions* gl_ = nullptr;
};

} // namespace aolib
