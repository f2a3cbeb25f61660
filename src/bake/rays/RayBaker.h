#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <aolib/bake/AbstractBaker.h>

#include "bake/geometry/BakeGeometry.h"
#include "bake/maps/ProgressiveBake.h"
#include "bake/maps/TexelReceivers.h"
#include "bake/rays/ReceiverTracer.h"
#include "bake/vertices/VertexWeld.h"
#include "raytracing/RayScene.h"

namespace aolib::bake {

/// Bakes by rays on all cores (GPU Gems, chapter 17.2).
class RayBaker final : public AbstractBaker {
public:
    RayBaker(BakeGeometry geometry, RayScene scene, const RayOptions& options)
        : geometry_(std::move(geometry)), rays_(std::move(scene)), options_(options) {}

    Result<std::vector<BakedMap>> bakeMaps(const MapOptions& options, const BakeProgress& progress,
                                           const SnapshotCallback& onSnapshot) override;
    Result<std::vector<BakedVertices>> bakeVertices(const VertexOptions& options,
                                                    const BakeProgress& progress) override;
    Result<BakedMap> bakeView(const ViewPixels& view, const BakeProgress& progress) override;

private:
    /// Fills up to `ReceiverTracer::capacity` receivers of a group, and says how many.
    using FillGroup = std::function<std::size_t(std::size_t group, Receiver* receivers)>;
    using TakeResult =
        std::function<void(const Receiver& receiver, const HemisphereSample& sample)>;

    bool traceGroups(std::size_t groups, const SampleRange& rays, const FillGroup& fill,
                     const TakeResult& take, const BakeProgress& progress) const;
    AoStatus addRays(const SampleRange& rays, int number, MapSums& map,
                     const BakeProgress& progress) const;
    /// W and direction of each point.
    /// @param sectors  null: sectors are not computed.
    Result<std::vector<glm::vec4>> tracePoints(const std::vector<SurfacePoint>& points,
                                               std::vector<OpenSectors>* sectors,
                                               const BakeProgress& progress) const;
    SequenceSeed makeSeed(int kind, std::size_t a, std::size_t b) const;

    BakeGeometry geometry_;
    RayScene rays_;
    RayOptions options_;
};

} // namespace aolib::bake
