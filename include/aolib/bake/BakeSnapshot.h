#pragma once

#include <functional>
#include <vector>

#include <aolib/BakeExport.h>
#include <aolib/Status.h>

namespace aolib::bake {

struct BakedMap;

/// A bake in progress: how many samples it has, and the maps that they give. Since 0.1.
class AOLIB_BAKE_EXPORT BakeSnapshot {
public:
    BakeSnapshot() = default;
    BakeSnapshot(const BakeSnapshot&) = delete;
    BakeSnapshot& operator=(const BakeSnapshot&) = delete;
    virtual ~BakeSnapshot();

    /// Returns the number of rays or directions per texel, in the map that has the fewest; at
    /// least 1.
    virtual int samples() const = 0;
    /// Returns the number of samples per texel that the finished bake has.
    virtual int wantedSamples() const = 0;
    /// Returns the maps that bakeMaps() would return if the bake ended here, padded and filled.
    /// A call takes as long as some samples do: make it now and then. Errors: OutOfMemory.
    virtual Result<std::vector<BakedMap>> maps() = 0;
};

/// Called in the calling thread whenever all maps have further samples; returning false ends the
/// bake, which then succeeds with the maps so far. Samples are spread evenly, whatever their
/// number. Scattering calls it after every few directions. Rays and shadow maps call it after each
/// pass over a map: there are `MapOptions::texelSamples` passes, or as many as passes of 64 samples
/// need, whichever are more. Since 0.1.
using SnapshotCallback = std::function<bool(BakeSnapshot& snapshot)>;

} // namespace aolib::bake
