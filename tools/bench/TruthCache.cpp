#include "bench/TruthCache.h"

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <system_error>

#include "bench/Fingerprint.h"
#include "image/FileContent.h"

namespace aolib::bench {

namespace {

using Bytes = std::vector<std::uint8_t>;

template <typename T>
void append(Bytes& bytes, std::span<const T> values) {
    const auto raw = std::as_bytes(values);
    const auto* first = reinterpret_cast<const std::uint8_t*>(raw.data());
    bytes.insert(bytes.end(), first, first + raw.size());
}

} // namespace

std::filesystem::path TruthCache::file(const std::string& key) const {
    Fingerprint fingerprint;
    fingerprint.add(key);
    char name[32];
    std::snprintf(name, sizeof(name), "%016" PRIx64 ".truth", fingerprint.value());
    return folder_ / name;
}

std::optional<TruthCache::Values> TruthCache::read(const std::string& key,
                                                   std::size_t count) const {
    std::error_code ignored;
    if (folder_.empty() || !std::filesystem::is_regular_file(file(key), ignored)) {
        return std::nullopt;
    }
    const Result<Bytes, ImageError> content = readFile(file(key));
    const std::size_t part = count * sizeof(float);
    if (!content || content->size() != key.size() + 2 * part ||
        std::memcmp(content->data(), key.data(), key.size()) != 0) {
        return std::nullopt;
    }
    Values values{std::vector<float>(count), std::vector<float>(count)};
    if (count > 0) {
        std::memcpy(values.visibility.data(), content->data() + key.size(), part);
        std::memcpy(values.standardError.data(), content->data() + key.size() + part, part);
    }
    return values;
}

std::string TruthCache::write(const std::string& key, const std::vector<float>& visibility,
                              const std::vector<float>& standardError) const {
    if (folder_.empty()) {
        return "";
    }
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) {
        return folder_.string() + ": " + error.message();
    }
    Bytes bytes;
    append(bytes, std::span<const char>(key));
    append(bytes, std::span<const float>(visibility));
    append(bytes, std::span<const float>(standardError));
    const ImageOutcome failure = writeFile(file(key), bytes);
    return failure ? failure->message : "";
}

} // namespace aolib::bench
