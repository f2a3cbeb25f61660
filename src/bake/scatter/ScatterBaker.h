#pragma once

#include <utility>
#include <vector>

#include <aolib/bake/AbstractBaker.h>

#include "bake/gpu/GpuBake.h"
#include "bake/scatter/VertexSums.h"

namespace aolib::bake {

/// Bakes maps and vertices by scattering what each direction of light sees (McGraw and Sowers
/// 2008).
class ScatterBaker final : public AbstractBaker {
public:
    ScatterBaker(GpuBake gpu, const ScatterOptions& options)
        : gpu_(std::move(gpu)), options_(options) {}

    Result<std::vector<BakedMap>> bakeMaps(const MapOptions& options, const BakeProgress& progress,
                                           const SnapshotCallback& onSnapshot) override;
    Result<std::vector<BakedVertices>> bakeVertices(const VertexOptions& options,
                                                    const BakeProgress& progress) override;
    Result<BakedMap> bakeView(const ViewPixels& view, const BakeProgress& progress) override;

private:
    AoStatus sumVertices(VertexSums& sums, const BakeProgress& progress) const;

    GpuBake gpu_;
    ScatterOptions options_;
};

} // namespace aolib::bake
