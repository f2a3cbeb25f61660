#include "GoldenPicture.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "image/Png.h"

namespace aolib::test {

namespace {

namespace fs = std::filesystem;

struct Error {
    double max = 0.0;
    double mean = 0.0;
    int x = 0; ///< of the worst pixel
    int y = 0;
};

/// How far a value lies outside the range of the golden one's neighbourhood.
int distance(const ByteImage& picture, const ByteImage& golden, int x, int y, int channel) {
    int low = 255;
    int high = 0;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, golden.height - 1); ++v) {
        for (int u = std::max(x - 1, 0); u <= std::min(x + 1, golden.width - 1); ++u) {
            low = std::min<int>(low, golden.at(u, v, channel));
            high = std::max<int>(high, golden.at(u, v, channel));
        }
    }
    const int value = picture.at(x, y, channel);
    return std::max({low - value, value - high, 0});
}

Error compare(const ByteImage& picture, const ByteImage& golden) {
    Error error;
    for (int y = 0; y < golden.height; ++y) {
        for (int x = 0; x < golden.width; ++x) {
            for (int channel = 0; channel < golden.channels; ++channel) {
                const int d = distance(picture, golden, x, y, channel);
                error.mean += d;
                if (d > error.max) {
                    error = {static_cast<double>(d), error.mean, x, y};
                }
            }
        }
    }
    error.mean /= static_cast<double>(golden.pixels.size());
    return error;
}

testing::AssertionResult update(const ByteImage& picture, const fs::path& file) {
    if (const ImageOutcome outcome = writePng(file, picture)) {
        return testing::AssertionFailure() << outcome->message;
    }
    return testing::AssertionFailure() << file << " was rewritten: look at it, then test again "
                                       << "without AOLIB_UPDATE_GOLDENS";
}

} // namespace

testing::AssertionResult matchesGolden(const ByteImage& picture, const std::string& name,
                                       const GoldenThresholds& thresholds) {
    const fs::path file = fs::path(AOLIB_GOLDEN_FOLDER) / (name + ".png");
    const char* wish = std::getenv("AOLIB_UPDATE_GOLDENS");
    if (wish != nullptr && std::string_view(wish) == "1") {
        return update(picture, file);
    }
    const Result<ByteImage, ImageError> golden = readPng(file);
    if (!golden) {
        return testing::AssertionFailure() << golden.error().message;
    }
    if (picture.width != golden->width || picture.height != golden->height ||
        picture.channels != golden->channels) {
        return testing::AssertionFailure() << name << ": size or channels differ";
    }
    const Error error = compare(picture, *golden);
    testing::Test::RecordProperty(name + " max", std::to_string(error.max));
    testing::Test::RecordProperty(name + " mean", std::to_string(error.mean));
    if (error.max <= thresholds.max && error.mean <= thresholds.mean) {
        return testing::AssertionSuccess();
    }
    const fs::path seen = fs::path(AOLIB_TEST_FOLDER) / (name + ".png");
    fs::create_directories(seen.parent_path());
    writePng(seen, picture);
    return testing::AssertionFailure()
           << name << ": max " << error.max << " at (" << error.x << ", " << error.y << ") of "
           << thresholds.max << " allowed, mean " << error.mean << " of " << thresholds.mean
           << "; seen: " << seen;
}

} // namespace aolib::test
