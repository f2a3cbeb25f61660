#pragma once

#include <optional>
#include <vector>

#include "app/BakeDestination.h"
#include "app/BakeFlags.h"
#include "app/BakeInput.h"
#include "content/MovingGltf.h"

namespace aolib::app {

/// Attributes of the model's vertices, two for each of several poses: _AO_0, _BENT_NORMAL_0, _AO_1,
/// ...; the times go to the primitive's extras.
class BakeToPoses final : public AbstractBakeDestination {
public:
    /// Both must outlive it.
    BakeToPoses(BakeInput& input, const BakeFlags& flags) : input_(input), flags_(flags) {}

    MaybeFailure prepare(OutputFiles& files) override;
    std::size_t rounds() const override { return flags_.poses.size(); }
    MaybeFailure beginRound(std::size_t round) override;
    AoStatus bake(bake::AbstractBaker& baker, const bake::BakeProgress& progress) override;
    Result<std::string, Failure> put(OutputFiles& files) override;

private:
    BakeInput& input_;
    const BakeFlags& flags_;
    std::optional<MovingGltf> moving_;
    PosedModel posed_; ///< of the round
    /// By pose, then piece; bent normals as the mesh is at rest.
    std::vector<std::vector<bake::BakedVertices>> poses_;
};

} // namespace aolib::app
