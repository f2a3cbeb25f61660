#include "bench/bake/BakedMapFile.h"

#include <cstddef>

#include "image/Pfm.h"

namespace aolib::bench {

namespace {

std::filesystem::path withEnd(std::filesystem::path path, const char* end) {
    path += end;
    return path;
}

} // namespace

void writeBakedMap(const std::filesystem::path& path, const bake::BakedMap& map) {
    FloatImage values(map.width, map.height, 3);
    FloatImage bent(map.width, map.height, 3);
    for (std::size_t i = 0; i < map.visibility.size(); ++i) {
        values.pixels[3 * i] = map.visibility[i];
        values.pixels[3 * i + 1] = static_cast<float>(map.kind[i]);
        for (int k = 0; k < 3; ++k) {
            bent.pixels[3 * i + static_cast<std::size_t>(k)] = map.bentNormal[i][k];
        }
    }
    std::error_code ignored;
    std::filesystem::create_directories(path.parent_path(), ignored);
    // The normals first: with the values the map counts as written.
    if (!writePfm(withEnd(path, "-bent.pfm"), bent)) {
        static_cast<void>(writePfm(withEnd(path, ".pfm"), values));
    }
}

std::optional<bake::BakedMap> readBakedMap(const std::filesystem::path& path) {
    const auto values = readPfm(withEnd(path, ".pfm"));
    const auto bent = readPfm(withEnd(path, "-bent.pfm"));
    if (!values || !bent || values->channels != 3 || bent->channels != 3 ||
        values->width != bent->width || values->height != bent->height) {
        return std::nullopt;
    }
    bake::BakedMap map;
    map.width = values->width;
    map.height = values->height;
    for (std::size_t i = 0; i + 2 < values->pixels.size(); i += 3) {
        map.visibility.push_back(values->pixels[i]);
        map.kind.push_back(static_cast<bake::TexelKind>(values->pixels[i + 1]));
        map.bentNormal.emplace_back(bent->pixels[i], bent->pixels[i + 1], bent->pixels[i + 2]);
    }
    return map;
}

} // namespace aolib::bench
