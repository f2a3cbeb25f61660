#pragma once

#include <cstddef>
#include <vector>

#include <aolib/Status.h>

#include "backbone/cubemapped/CubeMapProjector.h"

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
    /// Whether it is about to look at the scene, over several frames.
    virtual bool capturing(CubeMapId /*id*/) const { return false; }
    /// Forgets what it holds for a cube map that is gone or has to begin again.
    virtual void forget(CubeMapId id) = 0;
    /// GPU memory held for cube maps on their way.
    virtual std::size_t bytes() const { return 0; }
};

} // namespace aolib
