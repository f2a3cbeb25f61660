#include "image/Pfm.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/FileContent.h"

namespace aolib {

namespace {

constexpr int largestPfm = 65536;

struct Header {
    int width = 0;
    int height = 0;
    int channels = 0;
    bool littleEndian = true;
    std::size_t length = 0; ///< bytes, up to the first value
};

bool isSpace(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

/// Takes words apart; behind each stands exactly one blank that belongs to it, more may follow.
class Words {
public:
    explicit Words(std::string_view text) : text_(text) {}

    /// The next word, empty at the end or when it is longer than any word of a PFM header.
    std::string_view next() {
        while (position_ < text_.size() && isSpace(text_[position_])) {
            ++position_;
        }
        const std::size_t begin = position_;
        while (position_ < text_.size() && !isSpace(text_[position_]) &&
               position_ - begin < longestWord) {
            ++position_;
        }
        const std::string_view word = text_.substr(begin, position_ - begin);
        if (position_ >= text_.size() || !isSpace(text_[position_])) {
            return {};
        }
        ++position_;
        return word;
    }
    std::size_t position() const { return position_; }

private:
    static constexpr std::size_t longestWord = 32;
    std::string_view text_;
    std::size_t position_ = 0;
};

template <typename T>
bool parse(std::string_view word, T& value) {
    const char* end = word.data() + word.size();
    const auto result = std::from_chars(word.data(), end, value);
    return result.ec == std::errc() && result.ptr == end;
}

/// The header, or the reason why there is none.
Result<Header, ImageError> parseHeader(std::string_view text) {
    Header header;
    Words words(text);
    const std::string_view kind = words.next();
    if (kind != "Pf" && kind != "PF") {
        return ImageError{"not a PFM file, it does not begin with Pf or PF"};
    }
    header.channels = kind == "Pf" ? 1 : 3;
    const std::string_view width = words.next();
    const std::string_view height = words.next();
    if (!parse(width, header.width) || !parse(height, header.height)) {
        return ImageError{"its header has no width and height"};
    }
    if (header.width < 1 || header.width > largestPfm || header.height < 1 ||
        header.height > largestPfm) {
        return ImageError{"its header says " + std::to_string(header.width) + " x " +
                          std::to_string(header.height) + " pixels, must be 1 to " +
                          std::to_string(largestPfm) + " each way"};
    }
    double scale = 0.0;
    if (!parse(words.next(), scale) || !std::isfinite(scale) || scale == 0.0) {
        return ImageError{"its header has no scale other than 0"};
    }
    header.littleEndian = scale < 0.0;
    header.length = words.position();
    return header;
}

void appendFloat(std::vector<std::uint8_t>& bytes, float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    for (unsigned shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<std::uint8_t>(bits >> shift));
    }
}

float floatFrom(std::span<const std::uint8_t, 4> bytes, bool littleEndian) {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        bits = (bits << 8U) | bytes[littleEndian ? 3 - i : i];
    }
    return std::bit_cast<float>(bits);
}

} // namespace

ImageOutcome writePfm(const std::filesystem::path& file, const FloatImage& image) {
    if (image.channels != 1 && image.channels != 3) {
        return ImageError{file.string() + ": PFM holds 1 or 3 channels, not " +
                          std::to_string(image.channels)};
    }
    if (image.width < 1 || image.height < 1 ||
        image.pixels.size() != image.pixelCount() * static_cast<std::size_t>(image.channels)) {
        return ImageError{file.string() + ": the picture to write is " +
                          std::to_string(image.width) + " x " + std::to_string(image.height) +
                          " pixels but holds " + std::to_string(image.pixels.size()) + " values"};
    }
    const std::string header = std::string(image.channels == 1 ? "Pf\n" : "PF\n") +
                               std::to_string(image.width) + " " + std::to_string(image.height) +
                               "\n-1.0\n";
    std::vector<std::uint8_t> bytes(header.begin(), header.end());
    bytes.reserve(bytes.size() + 4 * image.pixels.size());
    for (const float value : image.pixels) {
        appendFloat(bytes, value);
    }
    return writeFile(file, bytes);
}

Result<FloatImage, ImageError> readPfm(const std::filesystem::path& file) {
    const Result<std::vector<std::uint8_t>, ImageError> content = readFile(file);
    if (!content) {
        return ImageError{content.error().message};
    }
    const std::string_view text(reinterpret_cast<const char*>(content->data()), content->size());
    const Result<Header, ImageError> header = parseHeader(text);
    if (!header) {
        return ImageError{file.string() + ": " + header.error().message};
    }
    const std::size_t expected = std::size_t{4} * static_cast<std::size_t>(header->width) *
                                 static_cast<std::size_t>(header->height) *
                                 static_cast<std::size_t>(header->channels);
    const std::size_t present = content->size() - header->length;
    if (present != expected) {
        return ImageError{file.string() + ": " + (present < expected ? "truncated" : "too long") +
                          ", " + std::to_string(present) + " bytes of values where " +
                          std::to_string(header->width) + " x " + std::to_string(header->height) +
                          " pixels of " + std::to_string(header->channels) + " channels take " +
                          std::to_string(expected)};
    }
    FloatImage image(header->width, header->height, header->channels);
    const std::span<const std::uint8_t> bytes(*content);
    std::size_t offset = header->length;
    for (float& value : image.pixels) {
        value = floatFrom(bytes.subspan(offset).first<4>(), header->littleEndian);
        offset += 4;
    }
    return image;
}

} // namespace aolib
