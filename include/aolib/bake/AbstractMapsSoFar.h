#pragma once

#include <functional>
#include <vector>

#include <aolib/BakeExport.h>
#include <aolib/Status.h>

namespace aolib::bake {

struct BakedMap;

/// The maps of a bake that is under way. Since 0.1.
class AOLIB_BAKE_EXPORT AbstractMapsSoFar {
public:
    AbstractMapsSoFar() = default;
    AbstractMapsSoFar(const AbstractMapsSoFar&) = delete;
    AbstractMapsSoFar& operator=(const AbstractMapsSoFar&) = delete;
    virtual ~AbstractMapsSoFar();

    /// Rays or directions that each texel has got, in the map that has got the fewest; 1 or more.
    virtual int samples() const = 0;
    /// Of so many.
    virtual int wantedSamples() const = 0;
    /// What bakeMaps() gives if the bake ends here, padded and filled: ask for it now and then, for
    /// that takes as long as some samples do. Errors: OutOfMemory.
    virtual Result<std::vector<BakedMap>> maps() = 0;
};

/// Told whenever all maps have got further samples, from the calling thread; returning false ends
/// the bake there, which then succeeds with the maps so far. Samples are spread well, whatever
/// number of them there is. Scattering tells after every few directions; rays and shadow maps after
/// each pass over a map, of `MapOptions::texelSamples` passes or of 64 samples each, whichever are
/// more. Since 0.1.
using BakeWatch = std::function<bool(AbstractMapsSoFar& soFar)>;

} // namespace aolib::bake
