#pragma once

#include <memory>
#include <optional>

#include "backbone/cubemaps/CubeMapProjector.h"
#include "backbone/texels/AbstractCapture.h"
#include "backbone/texels/DrawnCapture.h"
#include "backbone/texels/LayerPeeling.h"

namespace aolib {

/// A cube map that is computed: the capture that its estimator reads, and the sums so far. Lives
/// only as long as there is something to compute.
struct CubeMapCapture {
    std::unique_ptr<AbstractCapture> geometry;
    gl::RenderToTexture2D accumulated; ///< six faces side by side: blocked weight, weight
    gl::RenderToTexture2D hidden; ///< the same of the surfaces behind a tile, and a texel about
    bool ready = false;           ///< texels can be computed

    WorkUnit next() const { return geometry->complete() ? WorkUnit::Prepare : geometry->next(); }
    bool waits() const { return !geometry->complete() && geometry->waits(); }
    std::size_t bytes() const {
        return geometry->bytes() + accumulated.bytes() + (hidden ? hidden.bytes() : 0);
    }
};

/// Captures the scene's geometry on the faces of a cube map and computes the ambient occlusion of
/// its texels (thesis 4.2 and 4.3), tile by tile and pass by pass: each pass adds to what those
/// before it have found.
class DeferredShading {
public:
    /// Errors: ShaderError.
    static Result<DeferredShading> create(const BackboneContext& context);

    /// What the options' estimator reads of the surroundings of a point, not captured yet.
    struct Surroundings {
        std::unique_ptr<AbstractCapture> capture;
        DistanceRange range; ///< of what is there
    };
    /// Errors: NoScene, ShaderError.
    /// @param view     seen from there, too: of layers of triangles
    Result<Surroundings> surroundings(const BackboneContext& context, const SceneGeometry& geometry,
                                      const glm::dvec3& centre, int faceSize,
                                      const std::optional<ViewFace>& view = {});

    /// Begins a capture. Errors: NoScene, ShaderError.
    Result<CubeMapCapture> begin(const BackboneContext& context, const SceneGeometry& geometry,
                                 CubeMapProjector& projector);
    /// The next unit of a capture that is not ready; the last ones make room for what is computed,
    /// and for the faces that hold geometry. Waits if the capture does. Errors: MissingCapability,
    /// OutOfMemory.
    static AoStatus step(const BackboneContext& context, CubeMapCapture& capture,
                         CubeMapProjector& projector);
    /// Adds passes [first, first + count) to the texels of a region.
    void accumulate(const BackboneContext& context, const CubeMapCapture& capture,
                    const TileTable::Region& region, int first, int count);
    /// Writes what has been found of a region to the store. @param share  of all passes it has had
    void resolve(const BackboneContext& context, const CubeMapCapture& capture,
                 const CubeMapProjector& projector, const FaceStore& store,
                 const TileTable::Region& region, float share);

    /// A pass over the surfaces of a tile that lie behind `layer` others, from pass 0 to the last
    /// one before those of another tile or layer. Errors: OutOfMemory, MissingCapability.
    AoStatus accumulateHidden(const BackboneContext& context, CubeMapCapture& capture,
                              const TileTable::Region& region, int layer, int pass);
    /// Writes what all passes have found of them to a block.
    void resolveHidden(const BackboneContext& context, const CubeMapCapture& capture,
                       const CubeMapProjector& projector, const PageStore& pages, int page,
                       const TileTable::Region& region, int layer);

private:
    /// Receivers of a face: those of its first surfaces, or of the ones behind.
    struct Receivers {
        int face;
        int layer;         ///< of surfaces, 0 is the first
        glm::ivec2 origin; ///< where the face's first texel would lie in what accumulates
    };
    void addPasses(const BackboneContext& context, const CubeMapCapture& capture,
                   const Receivers& receivers, int first, int count);
    void keep(const BackboneContext& context, const CubeMapCapture& capture,
              const CubeMapProjector& projector, const Receivers& receivers,
              const gl::RenderToTexture2D& accumulated, const glm::ivec2& keptOrigin, float share);
    AoStatus chooseEstimator(const BackboneContext& context);

    gl::GLSLShader capture_;
    LayerPeeling peeling_;
    DrawnCapture::Shaders drawn_;
    gl::GLSLShader visibility_;
    gl::GLSLShader resolve_;
    std::optional<Estimator> estimator_; ///< that `visibility_` and `resolve_` were built for
};

} // namespace aolib
