#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/BakeDestination.h"
#include "app/BakeFlags.h"
#include "app/BakeInput.h"
#include "app/BakePlan.h"
#include "app/BakePreview.h"

namespace aolib::app {

/// Maps: occlusion textures of the model's materials, and files of their own.
class BakeToTexture final : public AbstractBakeDestination {
public:
    /// Both must outlive it.
    BakeToTexture(BakeInput& input, const BakeFlags& flags) : input_(input), flags_(flags) {}

    MaybeFailure prepare(OutputFiles& files) override;
    AoStatus bake(bake::AbstractBaker& baker, const bake::BakeProgress& progress) override;
    Result<std::string, Failure> put(OutputFiles& files) override;
    void succeed() override;

private:
    std::filesystem::path mapFile(const std::string& file, std::size_t number) const;
    void putMap(OutputFiles& files, std::size_t number);

    BakeInput& input_;
    const BakeFlags& flags_;
    std::vector<PlannedMap> plans_;
    std::vector<bake::BakedMap> maps_;
    std::optional<BakePreview> preview_;
};

} // namespace aolib::app
