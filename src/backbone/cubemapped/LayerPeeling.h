#pragma once

#include <vector>

#include "backbone/cubemapped/FaceCapture.h"
#include "gl/TextureStack.h"

namespace aolib {

/// Captures a cube map's surroundings as layers of solid intervals [entry, exit] along each texel's
/// ray, nearest first. The intervals are counted before, so that no more layers are made than there
/// are.
///
/// Open meshes are mostly seen from one side only, as walls and hulls are: then what lies behind
/// that side, up to the next surface, is out of sight, and taking it as solid is right wherever a
/// ray comes from. The sheets of a mesh that show both sides (leaves, cloth) stay without
/// thickness.
class LayerPeeling {
public:
    static constexpr int kMostLayers = 8;

    /// Errors: ShaderError.
    static Result<LayerPeeling> create(const BackboneContext& context);

    struct Layers {
        /// Six faces side by side per layer: entry (-1 none), exit, octahedral normal.
        gl::TextureStack intervals;
        std::array<bool, kFaces> modelled{}; ///< faces that hold geometry
        std::size_t bytes = 0;               ///< GPU memory at the peak of the capture
    };
    /// @param most  layers at most, 1 to kMostLayers. Errors: MissingCapability, OutOfMemory.
    Result<Layers> capture(const BackboneContext& context, const SceneGeometry& geometry,
                           const CubeMapProjector& projector, const DistanceRange& range, int most);

    /// Binds the layers to texture unit 0 and sets the uniforms of
    /// shaders/cubemap/layered_view.glsl.
    static void bind(gl::GLSLShader& shader, const Layers& layers, int faceSize);

private:
    struct Targets;

    /// Finds which faces hold geometry, and the sheets of which not only the fronts show.
    void surveySides(const FaceCapture& faces, Targets& targets, int faceSize,
                     std::array<bool, kFaces>& modelled, const gl::Functions& gl);
    /// Most intervals along any ray, 1 to `most`.
    Result<int> countLayers(const FaceCapture& faces, const Targets& targets, int faceSize,
                            int most, const gl::Functions& gl);
    void peelEntries(const FaceCapture& faces, const Targets& targets,
                     const gl::RenderToTexture2D* previous, const gl::RenderToTexture2D& entry,
                     const gl::Functions& gl);
    void peelExits(const FaceCapture& faces, const Targets& targets,
                   const gl::RenderToTexture2D& entry, const gl::Functions& gl);

    gl::GLSLShader sides_;
    gl::GLSLShader count_;
    gl::GLSLShader entry_;
    gl::GLSLShader exit_;
    gl::GLSLShader pack_;
};

} // namespace aolib
