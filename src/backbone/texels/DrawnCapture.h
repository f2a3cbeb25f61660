#pragma once

#include <optional>

#include "backbone/texels/AbstractCapture.h"
#include "backbone/texels/FaceCapture.h"
#include "gl/RenderToTexture2D.h"
#include "gl/TextureStack.h"

namespace aolib {

/// The nearest surface of each texel, drawn by the host (AmbientOcclusion::setSceneRenderer): from
/// the depth that it leaves. A unit is a face.
class DrawnCapture final : public AbstractCapture {
public:
    /// cubemap/drawn_face.frag in its two forms, each built when first needed.
    struct Shaders {
        std::optional<gl::GLSLShader> nearest;   ///< normal, distance (-1 nothing)
        std::optional<gl::GLSLShader> intervals; ///< entry (-1 none), exit, octahedral normal

        /// Errors: ShaderError.
        AoStatus build(const BackboneContext& context, bool asIntervals);
    };

    /// The distances that a capture from `centre` holds: what is nearer is clipped.
    static DistanceRange distanceRange(const Scene& scene, const glm::vec3& centre);

    /// @param shaders      the form is built; outlives the capture.
    /// @param asIntervals  solid intervals of the assumed thickness; else the surface alone.
    DrawnCapture(const BackboneContext& context, const glm::vec3& centre, int size,
                 const DistanceRange& range, Shaders& shaders, bool asIntervals)
        : context_(context), centre_(centre), size_(size), range_(range),
          shader_(asIntervals ? *shaders.intervals : *shaders.nearest), asIntervals_(asIntervals) {}

    bool complete() const override { return face_ == kFaces; }
    WorkUnit next() const override { return depth_ ? WorkUnit::Draw : WorkUnit::Prepare; }
    /// Errors: CallbackFailed, MissingCapability, OutOfMemory.
    AoStatus step() override;
    void bind(gl::GLSLShader& shader) const override;
    std::array<bool, kFaces> modelled() const override { return modelled_; }
    int layers() const override { return 1; }
    std::size_t bytes() const override;
    std::size_t mostBytes() const override { return mostBytes_; }

private:
    AoStatus makeTargets();
    AoStatus drawFace(const FaceView& view) const;
    AoStatus convertFace(const FaceView& view);

    const BackboneContext context_;
    const glm::vec3 centre_;
    const int size_; ///< texels along a face's edge
    const DistanceRange range_;
    gl::GLSLShader& shader_;
    const bool asIntervals_;
    gl::RenderToTexture2D depth_;   ///< of one face
    gl::RenderToTexture2D nearest_; ///< six faces side by side, or ...
    gl::TextureStack intervals_;    ///< ... one layer for each face
    int face_ = 0;                  ///< the next
    std::array<bool, kFaces> modelled_{};
    std::size_t mostBytes_ = 0;
};

} // namespace aolib
