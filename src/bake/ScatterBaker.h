#pragma once

#include <span>
#include <vector>

#include <aolib/bake/AbstractBaker.h>

#include "bake/GpuBake.h"
#include "bake/PointShape.h"
#include "bake/ScatterPasses.h"
#include "bake/TexelRaster.h"
#include "bake/ThinTexels.h"
#include "bake/VertexSums.h"

namespace aolib::bake {

/// Bakes maps and vertices by scattering what each direction of light sees (McGraw and Sowers
/// 2008).
class ScatterBaker final : public AbstractBaker {
public:
    ScatterBaker(GpuBake gpu, const ScatterOptions& options)
        : gpu_(std::move(gpu)), options_(options) {}

    Result<std::vector<BakedMap>> bakeMaps(const MapOptions& options,
                                           const BakeProgress& progress) override;
    Result<std::vector<BakedVertices>> bakeVertices(const VertexOptions& options,
                                                    const BakeProgress& progress) override;

private:
    struct Sums;

    int rasterSize(const glm::ivec2& mapSize) const;
    float density(const std::vector<TexelRaster>& rasters) const;
    Result<ScatterPasses> passesFor(const ScatterPasses::Settings& settings,
                                    const std::vector<float>& facets) const;
    Result<Sums> sumStack(const ScatterPasses::Settings& settings, const BakeVertices& vertices,
                          std::span<const PointShape> shapes, const std::vector<float>& facets,
                          const BakeProgress& progress) const;
    Status sumVertices(VertexSums& sums, const BakeProgress& progress) const;
    BakedMap mapOf(const TexelRaster& raster, const TexelSums& own,
                   const MapOptions& options) const;

    GpuBake gpu_;
    ScatterOptions options_;
};

} // namespace aolib::bake
