#pragma once

#include <optional>
#include <span>
#include <vector>

#include <aolib/Statistics.h>
#include <aolib/Status.h>

#include "backbone/Blur.h"
#include "backbone/Composite.h"
#include "backbone/GeometryBuffer.h"
#include "backbone/ViewTable.h"
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
    /// Places cube maps, unless some stand there already; those placed by hand are to be computed.
    virtual AoStatus beginPreparing(std::span<const glm::vec3> positions);
    /// Goes on with them for about as long. @return how much is done; 1 when all is
    virtual Result<float> goOnPreparing(double milliseconds);
    virtual AoStatus removeCubeMap(CubeMapId id);
    virtual AoStatus clear();
    virtual std::vector<CubeMapInfo> cubeMaps() { return {}; }
    virtual Result<CubeMapImage> readCubeMap(CubeMapId id);

    /// Of the latest frame, of whatever view. Errors: InvalidCallOrder before the first frame.
    Result<VisibilityImage> readVisibility();
    /// Of the latest frame of a view. Errors: InvalidCallOrder where it had none.
    Result<VisibilityImage> readVisibility(ViewId id);
    Statistics statistics();
    Statistics statistics(ViewId id);
    /// Drops all that is kept for a view.
    void removeView(ViewId id) { views_.remove(id); }

protected:
    explicit AbstractBackbone(const BackboneContext& context)
        : context_(context), views_([this] { return makeView(); }) {}
    /// Builds what all strategies share. Errors: ShaderError, OutOfMemory.
    AoStatus initialise();

    /// What is kept for a view of the host's.
    virtual std::unique_ptr<ViewState> makeView() { return std::make_unique<ViewState>(); }
    /// The view of the frame that is drawn.
    ViewState& view() const { return *views_.current(); }

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
    /// What was done for a view in its latest frame; null before the first.
    virtual void addStatistics(Statistics& /*statistics*/, const ViewState* /*view*/) {}

    /// Radius in force, world units: the option's, or derived from the scene. A derived one is kept
    /// until the scene's size has changed by a quarter, so that small edits rebuild only what sees
    /// them.
    float radius();

    const BackboneContext context_;
    ViewTable views_;
    Composite composite_;

private:
    /// The view that a frame belongs to becomes the current one.
    void beginView(const Frame& frame) {
        views_.begin(frame.view, {frame.camera, frame.size, frame.clip});
    }
    AoStatus drawView(Frame& frame);
    /// Fills the current view's buffers for a frame. @return what computeVisibility() gave.
    Result<const gl::RenderToTexture2D*> fillBuffers(const Frame& frame);
    Result<VisibilityImage> readVisibility(ViewState* view);
    Statistics statisticsOf(const ViewState* view);

    /// W of a view's pixels as they are read: the means of their samples where the host has
    /// several.
    Result<const gl::RenderToTexture2D*> shownVisibility(const ViewState& of);

    GeometryPass geometryPass_;
    gl::RenderToTexture2D means_; ///< W, of hosts with samples, when it is read
    Blur blur_;
    gl::GpuTimer timer_;
    float derivedFrom_ = 0.0F; ///< scene size that the derived radius belongs to
    std::uint64_t frame_ = 0;
};

} // namespace aolib
