#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <aolib/bake/BakeOptions.h>

#include "bake/geometry/BakeGeometry.h"
#include "bake/maps/Facets.h"
#include "bake/maps/TexelRaster.h"

namespace aolib::bake {

/// Samples `first` to `last` - 1 of a receiver's.
struct SampleRange {
    int first = 0;
    int last = 0;
};

/// The samples of one of `places` places, all of which together have `count`.
SampleRange sampleRange(int count, int place, int places);

/// Where the texels of a map are looked at from: one place in each at a time.
class TexelReceivers {
public:
    /// All must outlive it.
    TexelReceivers(const BakeGeometry& geometry, const Facets& facets, int map,
                   const MapOptions& options);

    /// Of the texels' centres.
    const TexelRaster& raster() const { return centres_; }
    /// How many of the places that the options ask for `samples` samples can be shared among, each
    /// getting `least` or more.
    int placesFor(int samples, int least) const;

    /// From now on texels are looked at from one of `places` places, spread evenly over each; the
    /// only one is the centre.
    void moveTo(int place, int places);
    /// The place in a texel; where that shows another facet or none, the place before it that did
    /// not, at last the receiver at the centre. Nothing where the texel is empty or not wanted.
    std::optional<SurfacePoint> at(std::size_t texel) const;
    /// The receiver at its centre, wherever texels are looked at from.
    std::optional<SurfacePoint> centre(std::size_t texel) const;

private:
    bool has(std::size_t texel) const;
    void take(const TexelRaster& raster, bool inFacet);

    const BakeGeometry* geometry_;
    const Facets* facets_;
    int map_;
    int most_;
    const std::vector<std::uint8_t>* wanted_; ///< empty for all
    TexelRaster centres_;
    /// Per texel that is not empty: triangle and weights of its second and third vertex.
    std::vector<TriangleName> triangle_;
    std::vector<glm::vec2> barycentric_;
};

} // namespace aolib::bake
