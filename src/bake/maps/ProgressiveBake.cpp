#include "bake/maps/ProgressiveBake.h"

#include <algorithm>
#include <new>
#include <string>

#include "bake/maps/CheckOptions.h"
#include "bake/maps/MapFill.h"

namespace aolib::bake {

namespace {

/// The most samples that a texel gets in one pass: the more passes, the sooner a bake can be ended.
/// Receivers are made anew in each, which takes as long as a sample or two.
constexpr int samplesAtOnce = 64;

class ProgressiveBake final : public BakeSnapshot {
public:
    ProgressiveBake(const BakeGeometry& geometry, const MapOptions& options,
                    const TexelMethod& method)
        : options_(options), method_(method), facets_(geometry.scene()) {
        const int count = geometry.scene().mapCount();
        maps_.reserve(static_cast<std::size_t>(count));
        for (int number = 0; number < count; ++number) {
            maps_.emplace_back(geometry, facets_, number, options);
        }
    }

    bool covered() const {
        return std::any_of(maps_.begin(), maps_.end(), [](const MapSums& map) {
            return map.receivers.raster().coveredTexels() > 0;
        });
    }
    /// All passes, or those before `onSnapshot` says that it is enough.
    AoStatus run(const BakeProgress& progress, const SnapshotCallback& onSnapshot);

    int samples() const override {
        return std::min_element(maps_.begin(), maps_.end(),
                                [](const auto& a, const auto& b) { return a.samples < b.samples; })
            ->samples;
    }
    int wantedSamples() const override { return method_.samples; }
    Result<std::vector<BakedMap>> maps() override;

private:
    BakedMap makeMap(const MapSums& sums) const;

    const MapOptions& options_;
    const TexelMethod& method_;
    const Facets facets_;
    std::vector<MapSums> maps_;
};

AoStatus ProgressiveBake::run(const BakeProgress& progress, const SnapshotCallback& onSnapshot) {
    const int places = maps_.front().receivers.placesFor(method_.samples, method_.least);
    const int perRound = places * samplesAtOnce;
    const int passes = places * ((method_.samples + perRound - 1) / perRound);
    const int steps = passes * static_cast<int>(maps_.size());
    for (int step = 0; step < steps; ++step) {
        const int pass = step / static_cast<int>(maps_.size());
        const int number = step % static_cast<int>(maps_.size());
        MapSums& map = maps_[static_cast<std::size_t>(number)];
        const auto share = [&](double fraction) {
            return !progress || progress((double(step) + fraction) / double(steps));
        };
        const SampleRange range = sampleRange(method_.samples, pass, passes);
        map.receivers.moveTo(pass % places, places);
        if (AoStatus status = method_.add(range, number, map, share); !status) {
            return status;
        }
        map.samples = range.last;
        if (onSnapshot && samples() > 0 && !onSnapshot(*this)) {
            break;
        }
    }
    return {};
}

BakedMap ProgressiveBake::makeMap(const MapSums& sums) const {
    BakedMap map = emptyMap(sums.receivers.raster());
    const double norm = method_.norm(sums.samples);
    for (std::size_t i = 0; i < sums.light.size(); ++i) {
        if (const std::optional<SurfacePoint> point = sums.receivers.centre(i)) {
            setTexel(map, i, sums.light[i], norm, point->normal);
            map.visibility[i] = std::min(map.visibility[i], 1.0F);
        }
    }
    finish(map, options_);
    return map;
}

Result<std::vector<BakedMap>> ProgressiveBake::maps() try {
    std::vector<BakedMap> maps;
    for (const MapSums& sums : maps_) {
        maps.push_back(makeMap(sums));
    }
    return maps;
} catch (const std::bad_alloc&) {
    return noMemoryForMaps(options_);
}

} // namespace

AoStatus cancelledBake() {
    return {StatusCode::Cancelled, "the bake was cancelled"};
}

AoStatus noTexels() {
    return {StatusCode::InvalidPosition, "no triangle has UVs that cover a texel"};
}

AoStatus noMemoryForMaps(const MapOptions& options) {
    return {StatusCode::OutOfMemory, "no memory left for maps of " + std::to_string(options.width) +
                                         " x " + std::to_string(options.height) + " texels"};
}

AoStatus noMemoryForView() {
    return {StatusCode::OutOfMemory, "no memory left for the view's pixels"};
}

Result<std::vector<BakedMap>> bakeInPasses(const BakeGeometry& geometry, const MapOptions& options,
                                           const TexelMethod& method, const BakeProgress& progress,
                                           const SnapshotCallback& onSnapshot) try {
    if (AoStatus status = check(options); !status) {
        return status;
    }
    ProgressiveBake bake(geometry, options, method);
    if (!bake.covered()) {
        return noTexels();
    }
    if (AoStatus status = bake.run(progress, onSnapshot); !status) {
        return status;
    }
    Result<std::vector<BakedMap>> maps = bake.maps();
    if (maps && progress) {
        progress(1.0);
    }
    return maps;
} catch (const std::bad_alloc&) {
    return noMemoryForMaps(options);
}

} // namespace aolib::bake
