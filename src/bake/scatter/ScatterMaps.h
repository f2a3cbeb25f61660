#pragma once

#include <optional>
#include <vector>

#include <aolib/bake/AbstractBaker.h>

#include "bake/gpu/GpuBake.h"
#include "bake/maps/TexelRaster.h"
#include "bake/scatter/PointShape.h"
#include "bake/scatter/PointTarget.h"
#include "bake/scatter/ScatterPasses.h"

namespace aolib::bake {

/// One bake of maps by scattered points.
class ScatterMaps final : public BakeSnapshot {
public:
    /// All must outlive it.
    ScatterMaps(const GpuBake& gpu, const ScatterOptions& scatter, const MapOptions& options);

    /// Errors: InvalidPosition where no texel is covered, MissingCapability, ShaderError,
    /// OutOfMemory, Cancelled.
    AoStatus run(const BakeProgress& progress, const SnapshotCallback& onSnapshot);

    int samples() const override { return directions_; }
    int wantedSamples() const override { return scatter_.directions; }
    Result<std::vector<BakedMap>> maps() override;

private:
    void rasterise();
    int rasterSize() const;
    float density() const;
    AoStatus addStack(const BakeVertices& vertices, const BakeProgress& progress,
                      const SnapshotCallback& onSnapshot);
    Result<int> addDirections(const PointTarget& target, const BakeProgress& progress,
                              const SnapshotCallback& onSnapshot);
    void fetch();
    BakedMap makeMap(std::size_t number) const;
    std::size_t stackStart() const;
    std::size_t stackSize() const;

    const GpuBake& gpu_;
    const ScatterOptions& scatter_;
    const MapOptions& options_;
    const Facets facets_;
    std::vector<TexelRaster> rasters_; ///< per map
    ScatterPasses::Settings settings_;
    std::vector<PointShape> shapes_;
    std::optional<ScatterPasses> passes_; ///< of the stack that is being summed
    int directions_ = 0;                  ///< that all texels have got, or will have
    // Per texel, one map after the other.
    std::vector<glm::vec4> light_; ///< weighed direction, weight
    std::vector<float> coverage_;
    std::vector<float> owners_; ///< facets
};

} // namespace aolib::bake
