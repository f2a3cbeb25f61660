#pragma once

#include <vector>

#include <aolib/Statistics.h>
#include <aolib/Status.h>

#include "backbone/Blur.h"
#include "backbone/Composite.h"
#include "backbone/GeometryBuffer.h"
#include "gl/GpuTimer.h"

namespace aolib {

/// A strategy behind the facade (thesis 4.1). Its frame is always the same: read the host's depth,
/// let the strategy find each pixel's visibility, blur, blend. A strategy is a class that derives
/// from this one, in a folder of its own, and a line in makeBackbone().
///
/// Every call runs on the clean slate of a gl::StateGuard.
class AbstractBackbone {
public:
    virtual ~AbstractBackbone() = default;
    AbstractBackbone(const AbstractBackbone&) = delete;
    AbstractBackbone& operator=(const AbstractBackbone&) = delete;

    /// Darkens the host's picture. Errors: as AmbientOcclusion::aoDrawEnd().
    Status drawEnd(Frame& frame);
    /// The options changed from `before` to what the context now refers to.
    virtual void optionsChanged(const Options& before) = 0;

    /// Cube maps; a strategy that keeps none answers InvalidCallOrder.
    virtual Result<CubeMapId> addCubeMap(const glm::vec3& position);
    virtual Status removeCubeMap(CubeMapId id);
    virtual Status clear();
    virtual std::vector<CubeMapInfo> cubeMaps() { return {}; }
    virtual Result<CubeMapImage> readCubeMap(CubeMapId id);

    /// Errors: InvalidCallOrder before the first frame.
    Result<VisibilityImage> readVisibility();
    Statistics statistics();

protected:
    explicit AbstractBackbone(const BackboneContext& context) : context_(context) {}
    /// Builds what all strategies share. Errors: ShaderError, OutOfMemory.
    Status initialise();

    /// Finds each pixel's value (W) and log2 of its quality; below kUnshaded nothing is known.
    /// @return the target whose texture 0 holds them.
    virtual Result<const gl::RenderToTexture2D*> computeVisibility(const Frame& frame) = 0;
    /// After the composite: coverage, gizmos.
    virtual Status finishFrame(const Frame& /*frame*/) { return {}; }
    virtual void addStatistics(Statistics& /*statistics*/) {}

    /// Radius in force, world units: the option's, or derived from the scene. A derived one is kept
    /// until the scene's size has changed by a quarter, so that small edits rebuild only what sees
    /// them.
    float radius();

    const BackboneContext context_;
    GeometryBuffer geometry_;
    gl::RenderToTexture2D visibility_; ///< W (-1 background), shaded; size of the frame
    static constexpr float kUnshaded = -5.0e4F;

private:
    Blur blur_;
    Composite composite_;
    gl::GpuTimer timer_;
    float derivedFrom_ = 0.0F; ///< scene size that the derived radius belongs to
    std::uint64_t frame_ = 0;
};

} // namespace aolib
