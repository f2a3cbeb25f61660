#pragma once

#include <cstddef>
#include <vector>

#include <aolib/Status.h>

#include "backbone/cubemapped/FoundPixels.h"
#include "backbone/cubemapped/Projection.h"
#include "scene/Bounds.h"

namespace aolib {

/// A frame that shows what the one before has shown, its cube maps complete.
struct RestingView {
    const FrameContext& context;
    const ProjectedCubeMaps& cubeMaps;
};

/// What computes pixels of a view at rest, each by itself.
class AbstractPixelSource {
public:
    AbstractPixelSource() = default;
    virtual ~AbstractPixelSource() = default;
    AbstractPixelSource(const AbstractPixelSource&) = delete;
    AbstractPixelSource& operator=(const AbstractPixelSource&) = delete;

    /// Begins anew: another view, or another scene.
    virtual void restart() = 0;
    /// The cube maps have changed, the view has not.
    virtual void lookAgain() = 0;
    /// Whether a change of the scene may alter pixels that were found or are on their way.
    /// @param within  the region of the change and as far about it as occluders reach, world units
    /// @param texels  whether it alters texels of cube maps
    virtual bool isAltered(const Bounds& /*within*/, bool texels) const { return texels; }
    /// Goes on with the view it was last called with, or with the first after a restart.
    /// @param milliseconds  that it may take, as far as can be told beforehand; infinite: to the
    /// end
    virtual AoStatus advance(const RestingView& view, FoundPixels& found, double milliseconds) = 0;
    /// Whether nothing is left to do for the view.
    virtual bool done() const = 0;
    /// GPU memory that it holds until then.
    virtual std::size_t bytes() const = 0;
};

} // namespace aolib
