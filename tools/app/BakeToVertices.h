#pragma once

#include <vector>

#include "app/BakeDestination.h"
#include "app/BakeFlags.h"
#include "app/BakeInput.h"

namespace aolib::app {

/// Vectors as the numbers that they are made of, one after the other.
std::vector<float> componentsOf(const std::vector<glm::vec3>& vectors);

/// Attributes of the model's vertices.
class BakeToVertices final : public AbstractBakeDestination {
public:
    /// Both must outlive it.
    BakeToVertices(BakeInput& input, const BakeFlags& flags) : input_(input), flags_(flags) {}

    MaybeFailure prepare(OutputFiles& files) override;
    AoStatus bake(bake::AbstractBaker& baker, const bake::BakeProgress& progress) override;
    Result<std::string, Failure> put(OutputFiles& files) override;

private:
    MaybeFailure setVertices(const BakePiece& piece, const bake::BakedVertices& vertices);

    BakeInput& input_;
    const BakeFlags& flags_;
    std::vector<bake::BakedVertices> vertices_;
};

} // namespace aolib::app
