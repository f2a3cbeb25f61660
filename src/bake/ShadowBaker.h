#pragma once

#include <optional>
#include <span>
#include <vector>

#include <aolib/bake/AbstractBaker.h>

#include "bake/GpuBake.h"
#include "bake/MapLoop.h"
#include "bake/ShadowPasses.h"
#include "bake/TexelReceivers.h"

namespace aolib::bake {

/// Bakes maps and vertices by shadow maps (GPU Gems, chapter 17.3).
class ShadowBaker final : public AbstractBaker {
public:
    ShadowBaker(GpuBake gpu, const ShadowOptions& options)
        : gpu_(std::move(gpu)), options_(options) {}

    Result<std::vector<BakedMap>> bakeMaps(const MapOptions& options, const BakeProgress& progress,
                                           const BakeWatch& watch) override;
    Result<std::vector<BakedVertices>> bakeVertices(const VertexOptions& options,
                                                    const BakeProgress& progress) override;
    Result<BakedMap> bakeView(const ViewPixels& view, const BakeProgress& progress) override;

private:
    using Receivers = std::span<const std::optional<SurfacePoint>>;

    Result<ShadowPasses> passesFor(const glm::ivec2& size) const;
    Status add(ShadowPasses& passes, const BakeVertices& vertices, Receivers receivers,
               const SampleRange& directions, const BakeProgress& progress) const;
    std::vector<glm::vec4> sumsOf(const ShadowPasses& passes) const;
    Result<std::vector<glm::vec4>> valuesAt(const std::vector<SurfacePoint>& points,
                                            const BakeProgress& progress) const;

    GpuBake gpu_;
    ShadowOptions options_;
};

} // namespace aolib::bake
