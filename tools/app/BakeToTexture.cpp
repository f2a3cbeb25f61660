#include "app/BakeToTexture.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <utility>

#include "app/BakedImage.h"
#include "app/Table.h"

namespace aolib::app {

namespace {

/// The mean of W over texels that charts have, or -1 where there is none; and how many there are.
std::pair<double, std::size_t> meanOf(const bake::BakedMap& map) {
    double sum = 0.0;
    std::size_t covered = 0;
    for (std::size_t i = 0; i < map.kind.size(); ++i) {
        if (map.kind[i] == bake::TexelKind::Inside) {
            sum += double(map.visibility[i]);
            ++covered;
        }
    }
    return {covered > 0 ? sum / double(covered) : -1.0, covered};
}

} // namespace

MaybeFailure BakeToTexture::prepare(OutputFiles& files) {
    Result<std::vector<PlannedMap>, Failure> plans = planMaps(input_, flags_);
    if (!plans) {
        return plans.error();
    }
    plans_ = std::move(*plans);
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        for (const auto& [option, file] :
             {std::pair("--ao", &flags_.ao), std::pair("--bent-normals", &flags_.bentNormals),
              std::pair("--watch", &flags_.watch)}) {
            if (file->empty()) {
                continue;
            }
            if (MaybeFailure failure =
                    files.announce(option, mapFile(*file, i), bakedImageExtensions())) {
                return failure;
            }
        }
    }
    return std::nullopt;
}

AoStatus BakeToTexture::bake(bake::AbstractBaker& baker, const bake::BakeProgress& progress) {
    std::vector<std::filesystem::path> pictures;
    for (std::size_t i = 0; i < plans_.size() && !flags_.watch.empty(); ++i) {
        pictures.push_back(mapFile(flags_.watch, i));
    }
    preview_.emplace(flags_, std::move(pictures));
    Result<std::vector<bake::BakedMap>> baked =
        baker.bakeMaps(flags_.map, progress,
                       [this](bake::BakeSnapshot& snapshot) { return preview_->goesOn(snapshot); });
    if (!baked) {
        return baked.status();
    }
    maps_ = std::move(*baked);
    return {};
}

void BakeToTexture::succeed() {
    preview_->keep();
}

/// "map.png", or "map-NAME.png" where there are several.
std::filesystem::path BakeToTexture::mapFile(const std::string& file, std::size_t number) const {
    std::filesystem::path path(file);
    if (plans_.size() == 1) {
        return path;
    }
    std::string name;
    for (const char c : plans_[number].name) {
        name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    const auto same = std::count_if(plans_.begin(), plans_.end(), [&](const PlannedMap& other) {
        return other.name == plans_[number].name;
    });
    const std::string tail = "-" + name + (same > 1 ? "-" + std::to_string(number) : "");
    return path.parent_path() / (path.stem().string() + tail + path.extension().string());
}

void BakeToTexture::putMap(OutputFiles& files, std::size_t number) {
    const PlannedMap& plan = plans_[number];
    const bake::BakedMap& map = maps_[number];
    input_.edit.setOcclusionTexture(plan.material, encodedPng(occlusionImage(map), flags_.bits),
                                    plan.uvSet, plan.name + " occlusion");
    if (!flags_.ao.empty()) {
        putImage(files, mapFile(flags_.ao, number), occlusionImage(map), flags_.bits);
    }
    if (!flags_.bentNormals.empty()) {
        putImage(files, mapFile(flags_.bentNormals, number), directionImage(map), flags_.bits);
    }
}

Result<std::string, Failure> BakeToTexture::put(OutputFiles& files) {
    MaybeFailure failure = preview_->failure();
    if (!failure) {
        failure = preview_->write(maps_);
    }
    if (failure) {
        return *failure;
    }
    Table table({"map", "triangles", "texels", "shared", "charts", "mean W"});
    std::vector<std::string> remarks{"UVs"};
    for (std::size_t i = 0; i < plans_.size(); ++i) {
        putMap(files, i);
        const PlannedMap& plan = plans_[i];
        const auto [mean, covered] = meanOf(maps_[i]);
        char shared[32] = {};
        std::snprintf(shared, sizeof(shared), "%.2g%%", 100.0 * plan.given.overlap());
        table.add({plan.name, grouped(plan.given.triangles), grouped(covered), shared,
                   plan.charts > 0 ? grouped(plan.charts) : "-", knownNumber(mean, 3)});
        remarks.push_back("TEXCOORD_" + std::to_string(plan.uvSet) +
                          (plan.charts > 0 ? ", our own: " + plan.given.sentence() : ""));
    }
    return preview_->remark() + table.text(remarks);
}

} // namespace aolib::app
