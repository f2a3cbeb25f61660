#pragma once

#include <cstddef>
#include <vector>

#include <aolib/Status.h>

#include "backbone/cubemaps/CubeMapProjector.h"
#include "backbone/frame/Job.h"
#include "scene/Scene.h"

namespace aolib {

/// The job of computing the texels of cube maps: those tiles that are requested, in passes that
/// each make all of a cube map's tiles better before the next begins. What it finds, it writes to
/// the atlas and records in the cube map.
class AbstractTexelSource : public AbstractJob {
public:
    /// Passes until a tile is complete.
    virtual int passes() const = 0;
    /// Begins a frame's work on these cube maps, the first ones first.
    virtual void beginFrame(const std::vector<CubeMapProjector*>& projectors) = 0;
    /// Ends it: passes on to worker threads what is still pending. Errors: the tracer's.
    virtual AoStatus endFrame() { return {}; }
    /// Computes all that is requested of one cube map before it returns.
    virtual AoStatus complete(CubeMapProjector& projector) = 0;
    /// Whether something that is requested is still to be computed.
    virtual bool hasPending(const CubeMapProjector& projector) const = 0;
    /// Whether texels of complete tiles stay as they are, though others are still computed.
    virtual bool areFinal(const CubeMapProjector& /*projector*/) const { return true; }
    /// Marks the tiles that a change of the scene alters as outdated.
    /// @param reach  of occluders, world units; may be infinite
    virtual void sceneChanged(CubeMapProjector& projector, const Scene::Change& change,
                              float reach) = 0;
    /// Whether outdated tiles may be restarted now. Work that has begun ends before, where
    /// restarting again and again would never let it end.
    virtual bool mayRestart(const CubeMapProjector& /*projector*/) const { return true; }
    /// Restarts outdated tiles.
    virtual void restart(CubeMapProjector& projector) = 0;
    /// Drops what is held for a cube map that is removed, or of which nothing counts any more.
    virtual void forget(CubeMapId id) = 0;
    /// GPU memory held for cube maps that are computed.
    virtual std::size_t bytes() const { return 0; }
};

} // namespace aolib
