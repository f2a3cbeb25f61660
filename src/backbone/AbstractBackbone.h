#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include <aolib/Statistics.h>
#include <aolib/Status.h>

#include "backbone/ViewTable.h"
#include "backbone/passes/Blur.h"
#include "backbone/passes/Composite.h"
#include "backbone/passes/GeometryBuffer.h"
#include "gl/GpuTimer.h"

namespace aolib {

class BackboneCubemapped;

/// The passes that every strategy draws with.
struct FramePasses {
    /// Errors: ShaderError, OutOfMemory.
    static Result<FramePasses> create(const BackboneContext& context);

    GeometryPass geometry;
    Blur blur;
    Composite composite;
    gl::GpuTimer timer; ///< of whole frames
};

/// A strategy behind the facade (thesis 4.1): how a frame's visibility is found. A strategy is a
/// class that derives from this one, and a line in makeBackbone().
///
/// Every call runs on the known GL state of a gl::StateGuard.
class AbstractBackbone {
public:
    virtual ~AbstractBackbone() = default;
    AbstractBackbone(const AbstractBackbone&) = delete;
    AbstractBackbone& operator=(const AbstractBackbone&) = delete;

    /// Darkens the host's picture. Errors: as AmbientOcclusion::aoDrawEnd().
    AoStatus drawEnd(Frame& frame);
    /// Darkens textures of the host's, whose size and framebuffers become the frame's.
    /// Errors: as AmbientOcclusion::aoApply().
    Result<TextureName> apply(Frame& frame, const HostTextures& textures);
    /// The options changed from `before` to what the context now refers to.
    virtual void optionsChanged(const Options& before) = 0;
    /// Releases the tracer, which the host is about to exchange.
    virtual void dropTracer() {}
    /// Drops what was drawn by the host's scene renderer, which was exchanged.
    virtual void rendererChanged() {}
    /// The strategy that keeps cube maps, where this is it; else null.
    virtual BackboneCubemapped* cubemapped() { return nullptr; }

    /// Reads the latest frame, of whatever view. Errors: InvalidCallOrder before the first frame.
    Result<VisibilityImage> readVisibility();
    /// Reads the latest frame of a view. Errors: InvalidCallOrder where it had none.
    Result<VisibilityImage> readVisibility(ViewId id);
    Statistics statistics();
    Statistics statistics(ViewId id);
    /// Drops all that is kept for a view.
    void removeView(ViewId id) { views_.remove(id); }

protected:
    AbstractBackbone(const BackboneContext& context, FramePasses passes)
        : context_(context), passes_(std::move(passes)), views_([this] { return makeView(); }) {}

    /// Makes what is kept for a view of the host's.
    virtual std::unique_ptr<ViewState> makeView() { return std::make_unique<ViewState>(); }
    /// The view of the frame that is drawn.
    ViewState& view() const { return *views_.current(); }

    /// Draws a frame onto the host's picture, or the debug view in its place.
    virtual AoStatus drawFrame(const FrameContext& context) = 0;
    /// Writes each pixel's W to the view's `blurred.visibility`, for a frame whose depth is still
    /// in its `host`.
    virtual AoStatus computeVisibility(const FrameContext& context) = 0;
    /// Adds what was done for a view in its latest frame; null before the first.
    virtual void addStatistics(Statistics& /*statistics*/, const ViewState* /*view*/) {}

    /// Number of the frame that is drawn, of all views' frames; the first is 1.
    std::uint64_t frameNumber() const { return frames_ + 1; }

    const BackboneContext context_;
    FramePasses passes_;
    ViewTable views_;

private:
    /// Makes the view that a frame belongs to the current one.
    void beginView(const Frame& frame) {
        views_.begin(frame.view, {frame.camera, frame.size, frame.clip});
    }
    AoStatus drawView(Frame& frame);
    Result<VisibilityImage> readVisibility(ViewState* view);
    Statistics statisticsOf(const ViewState* view);
    /// W of a view's pixels as they are read: the means of their samples where the host has
    /// several.
    Result<const gl::RenderToTexture2D*> shownVisibility(const ViewState& of);

    gl::RenderToTexture2D means_; ///< W, of hosts with samples, when it is read
    std::uint64_t frames_ = 0;    ///< ended, of all views
};

} // namespace aolib
