#pragma once

#include <string>

#include "app/BakeDestination.h"
#include "app/BakeFlags.h"
#include "app/BakeInput.h"

namespace aolib::app {

/// A picture of the model from one of its cameras: what the camera sees is traced first, then
/// baked.
class BakeToView final : public AbstractBakeDestination {
public:
    /// Both must outlive it.
    /// @param model  name or path, as it was given.
    BakeToView(const BakeInput& input, const BakeFlags& flags, std::string model)
        : input_(input), flags_(flags), model_(std::move(model)) {}

    MaybeFailure prepare(OutputFiles& files) override;
    AoStatus bake(bake::AbstractBaker& baker, const bake::BakeProgress& progress) override;
    Result<std::string, Failure> put(OutputFiles& files) override;

private:
    const BakeInput& input_;
    const BakeFlags& flags_;
    std::string model_;
    std::string camera_;
    bake::ViewPixels view_;
    bake::BakedMap picture_;
};

} // namespace aolib::app
