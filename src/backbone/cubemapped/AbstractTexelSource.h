#pragma once

#include <cstddef>
#include <vector>

#include <aolib/Status.h>

#include "backbone/cubemapped/CubeMapProjector.h"
#include "scene/Scene.h"

namespace aolib {

/// What computes the texels of cube maps: those tiles that are asked for, in passes that each make
/// all of a cube map's tiles better before the next begins.
class AbstractTexelSource {
public:
    AbstractTexelSource() = default;
    virtual ~AbstractTexelSource() = default;
    AbstractTexelSource(const AbstractTexelSource&) = delete;
    AbstractTexelSource& operator=(const AbstractTexelSource&) = delete;

    /// Passes until a tile is complete.
    virtual int passes() const = 0;
    /// Computes all that is asked for of one cube map before it returns.
    virtual AoStatus complete(CubeMapProjector& projector) = 0;
    /// Goes on with these, the first ones first.
    /// @param milliseconds  that it may take, as far as can be told beforehand; one unit of work is
    ///                      done in any case.
    virtual AoStatus advance(const std::vector<CubeMapProjector*>& projectors,
                             double milliseconds) = 0;
    /// Waits until advance() has something to do, where others work for it, and at most so long.
    virtual void await(double /*milliseconds*/) {}
    /// Whether something that is asked for is still to be computed.
    virtual bool lacks(const CubeMapProjector& projector) const {
        return projector.tiles.lacks(passes());
    }
    /// Whether texels of complete tiles stay as they are, though others are still computed.
    virtual bool keeps(const CubeMapProjector& /*projector*/) const { return true; }
    /// The scene has changed: marks the tiles for which it has as outdated, and their cube map.
    /// What they show stays.
    /// @param reach  of occluders, world units; may be infinite
    virtual void sceneChanged(CubeMapProjector& projector, const Scene::Change& change,
                              float reach) = 0;
    /// Whether outdated tiles may begin again now. What is on its way ends before, where beginning
    /// again and again would never let it end.
    virtual bool mayRestart(const CubeMapProjector& /*projector*/) const { return true; }
    /// Outdated tiles begin again.
    virtual void restart(CubeMapProjector& projector) = 0;
    /// Forgets what it holds for a cube map that is gone or of which nothing counts any more.
    virtual void forget(CubeMapId id) = 0;
    /// GPU memory held for cube maps on their way.
    virtual std::size_t bytes() const { return 0; }
};

} // namespace aolib
