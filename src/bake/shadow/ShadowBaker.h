#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <aolib/bake/AbstractBaker.h>

#include "bake/gpu/BakeVertices.h"
#include "bake/gpu/GpuBake.h"
#include "bake/maps/TexelReceivers.h"
#include "bake/shadow/AbstractDepthPasses.h"
#include "bake/shadow/ReceiverSums.h"

namespace aolib::bake {

/// Bakes maps and vertices by shadow maps (GPU Gems, chapter 17.3).
class ShadowBaker final : public AbstractBaker {
public:
    ShadowBaker(GpuBake gpu, const ShadowOptions& options)
        : gpu_(std::move(gpu)), options_(options) {}

    Result<std::vector<BakedMap>> bakeMaps(const MapOptions& options, const BakeProgress& progress,
                                           const SnapshotCallback& onSnapshot) override;
    Result<std::vector<BakedVertices>> bakeVertices(const VertexOptions& options,
                                                    const BakeProgress& progress) override;
    Result<BakedMap> bakeView(const ViewPixels& view, const BakeProgress& progress) override;

private:
    using Receivers = std::span<const std::optional<SurfacePoint>>;
    /// What a grid of receivers takes.
    struct Work {
        int depthSize = 0; ///< texels along a depth map
        std::unique_ptr<AbstractDepthPasses> passes;
        ReceiverSums sums;
    };

    Result<Work> workFor(const BakeVertices& vertices, const glm::ivec2& size) const;
    Result<std::vector<glm::vec4>> computeSums(Work& work, Receivers receivers,
                                               const SampleRange& directions,
                                               const BakeProgress& progress) const;
    Result<std::vector<glm::vec4>> valuesAt(const std::vector<SurfacePoint>& points,
                                            const BakeProgress& progress) const;

    GpuBake gpu_;
    ShadowOptions options_;
};

} // namespace aolib::bake
