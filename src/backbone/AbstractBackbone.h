#pragma once

#include <optional>
#include <vector>

#include <aolib/Statistics.h>
#include <aolib/Status.h>

#include "backbone/AppliedTextures.h"
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
    AoStatus drawEnd(Frame& frame);
    /// The same for textures of the host's, which tell the frame's size and framebuffers.
    /// Errors: as AmbientOcclusion::aoApply().
    Result<TextureName> apply(Frame& frame, const HostTextures& textures);
    /// The options changed from `before` to what the context now refers to.
    virtual void optionsChanged(const Options& before) = 0;

    /// The tracer is about to be exchanged: nothing may hold on to it.
    virtual void dropTracer() {}
    /// The host's scene renderer was exchanged: nothing that was drawn counts any more.
    virtual void rendererChanged() {}

    /// Cube maps; a strategy that keeps none answers InvalidCallOrder.
    virtual Result<CubeMapId> addCubeMap(const glm::vec3& position);
    virtual AoStatus removeCubeMap(CubeMapId id);
    virtual AoStatus clear();
    virtual std::vector<CubeMapInfo> cubeMaps() { return {}; }
    virtual Result<CubeMapImage> readCubeMap(CubeMapId id);

    /// Errors: InvalidCallOrder before the first frame.
    Result<VisibilityImage> readVisibility();
    Statistics statistics();

protected:
    explicit AbstractBackbone(const BackboneContext& context) : context_(context) {}
    /// Builds what all strategies share. Errors: ShaderError, OutOfMemory.
    AoStatus initialise();

    /// Before anything is drawn: what the frame needs is computed.
    virtual AoStatus prepare(const Frame& /*frame*/) { return {}; }
    /// Whether shadeDirectly() can darken the picture in one pass; buffers are then not needed.
    virtual bool shadesDirectly() const { return false; }
    virtual AoStatus shadeDirectly(const Frame& /*frame*/) { return {}; }
    /// Finds each pixel's value: texture 0 of the target holds its weighted sum, log2 of its
    /// quality (below kUnshaded nothing is known), the code of a cube's face, and the weight.
    virtual Result<const gl::RenderToTexture2D*> computeVisibility(const Frame& frame) = 0;
    /// After the blur: fills in what computeVisibility() left without a value.
    /// @param visibility  W (-1 background), shaded
    virtual void fillIn(const Frame& /*frame*/, const gl::RenderToTexture2D& /*projected*/,
                        const gl::RenderToTexture2D& /*visibility*/) {}
    /// Whether its values are noisy, so that they must be blurred.
    virtual bool noisy() const { return true; }
    /// After the composite: survey, gizmos.
    virtual AoStatus finishFrame(const Frame& /*frame*/) { return {}; }
    virtual void addStatistics(Statistics& /*statistics*/) {}

    /// Radius in force, world units: the option's, or derived from the scene. A derived one is kept
    /// until the scene's size has changed by a quarter, so that small edits rebuild only what sees
    /// them.
    float radius();

    const BackboneContext context_;
    HostFramebuffer host_;
    GeometryBuffer geometry_; ///< of frames that are not shaded directly
    Composite composite_;

private:
    /// Fills geometry_ and visibility_ for a frame.
    /// @return what computeVisibility() gave.
    Result<const gl::RenderToTexture2D*> fillBuffers(const Frame& frame);

    /// W of pixels as they are read: the means of their samples where the host has several.
    Result<const gl::RenderToTexture2D*> shownVisibility(const Frame& frame);

    gl::RenderToTexture2D visibility_; ///< W (-1 background), shaded; size of the frame
    gl::RenderToTexture2D means_;      ///< W, of hosts with samples, when it is read
    std::optional<Frame> latest_;      ///< its depth is still in host_
    bool buffered_ = false;            ///< visibility_ belongs to the latest frame
    AppliedTextures applied_;
    Blur blur_;
    gl::GpuTimer timer_;
    float derivedFrom_ = 0.0F; ///< scene size that the derived radius belongs to
    std::uint64_t frame_ = 0;
};

} // namespace aolib
