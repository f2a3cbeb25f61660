#include "bench/TextFile.h"

#include <cstdint>
#include <span>

#include "image/FileContent.h"

namespace aolib::bench {

std::string writeText(const std::filesystem::path& file, const std::string& text) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
    const ImageOutcome failure = writeFile(file, std::span(bytes, text.size()));
    return failure ? failure->message : "";
}

} // namespace aolib::bench
