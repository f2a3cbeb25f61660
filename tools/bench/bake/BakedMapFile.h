#pragma once

#include <filesystem>
#include <optional>

#include <aolib/bake/AbstractBaker.h>

namespace aolib::bench {

/// A baked map as two PFM files, PATH.pfm (W, kind of texel) and PATH-bent.pfm. Failures are
/// silent: such a file only saves work.
void writeBakedMap(const std::filesystem::path& path, const bake::BakedMap& map);
std::optional<bake::BakedMap> readBakedMap(const std::filesystem::path& path);

} // namespace aolib::bench
