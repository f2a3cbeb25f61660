#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aolib::bench {

/// Traced truths in a folder, one file per key. A file holds its whole key, so that no collision of
/// names and no change of what a key says goes unnoticed.
class TruthCache {
public:
    struct Values {
        std::vector<float> visibility;
        std::vector<float> standardError;
    };

    /// @param folder  made when first written to; empty: nothing is kept.
    explicit TruthCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The values of a key; nothing where there is no file, or one that does not hold exactly this
    /// key and `count` values.
    std::optional<Values> read(const std::string& key, std::size_t count) const;
    /// Keeps values. Returns why that failed, or an empty text.
    std::string write(const std::string& key, const std::vector<float>& visibility,
                      const std::vector<float>& standardError) const;

    /// Where a key's values lie.
    std::filesystem::path file(const std::string& key) const;

private:
    std::filesystem::path folder_;
};

} // namespace aolib::bench
