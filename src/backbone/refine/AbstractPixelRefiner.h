#pragma once

#include <cstddef>
#include <optional>

#include <aolib/Status.h>

#include "backbone/frame/Job.h"
#include "backbone/passes/Projection.h"
#include "backbone/refine/RefinedPixels.h"
#include "scene/Bounds.h"

namespace aolib {

/// A frame that shows what the one before has shown, its cube maps complete.
struct StaticView {
    const FrameContext& context;
    const ProjectedCubeMaps& cubeMaps;
};

/// Computes pixels of a view at rest, each by itself: a job, whose calls are given the view and
/// what it writes to. All calls until restart() are for the same view.
class AbstractPixelRefiner {
public:
    AbstractPixelRefiner() = default;
    virtual ~AbstractPixelRefiner() = default;
    AbstractPixelRefiner(const AbstractPixelRefiner&) = delete;
    AbstractPixelRefiner& operator=(const AbstractPixelRefiner&) = delete;

    /// As AbstractJob::next().
    virtual std::optional<WorkUnit> next() = 0;
    /// As AbstractJob::isReady().
    virtual bool isReady() = 0;
    /// As AbstractJob::step().
    virtual Result<int> step(const StaticView& view, RefinedPixels& pixels, int most) = 0;
    /// As AbstractJob::await().
    virtual void await(const StaticView& view, double milliseconds) = 0;

    /// Begins anew: another view, or another scene.
    virtual void restart() = 0;
    /// Begins anew where it depends on the cube maps, which have changed.
    virtual void invalidate() = 0;
    /// Whether a change of the scene may alter pixels that were computed or are pending.
    /// @param within  region of the change, inflated by the reach of occluders, world units
    /// @param texels  whether it alters texels of cube maps
    virtual bool isAltered(const Bounds& /*within*/, bool texels) const { return texels; }
    /// Whether nothing is left to do for the view.
    virtual bool done() const = 0;
    /// GPU memory that it holds until then.
    virtual std::size_t bytes() const = 0;
};

} // namespace aolib
