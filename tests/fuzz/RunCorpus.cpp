// Runs a fuzz target over the files of a folder, each as it is and with some hundred changes of its
// bytes: what every build can do. Arguments: the folder and, optionally, how many changes. Without
// a folder or a file it fails.
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string_view>
#include <system_error>
#include <vector>

#include "FuzzTarget.h"

namespace {

using Input = std::vector<std::uint8_t>;

constexpr int kVariants = 400; ///< of each file, unless told otherwise

/// One to eight bytes changed, cut off, doubled or put elsewhere.
Input changed(Input input, std::mt19937& random) {
    const auto below = [&](std::size_t n) { return n == 0 ? 0 : random() % n; };
    for (std::size_t changes = 1 + below(8); changes > 0 && !input.empty(); --changes) {
        const std::size_t at = below(input.size());
        const auto place = input.begin() + static_cast<std::ptrdiff_t>(at);
        switch (below(5)) {
        case 0:
            input[at] = static_cast<std::uint8_t>(random());
            break;
        case 1:
            input[at] = static_cast<std::uint8_t>(input[at] ^ (1U << below(8)));
            break;
        case 2:
            input.resize(at);
            break;
        case 3:
            input.insert(place, static_cast<std::uint8_t>(random()));
            break;
        default:
            std::rotate(input.begin(), place, input.end());
            break;
        }
    }
    return input;
}

} // namespace

int main(int argc, char** argv) {
    std::vector<std::filesystem::path> files;
    int variants = kVariants;
    if (argc == 3) {
        const std::string_view text(argv[2]);
        if (std::from_chars(text.data(), text.data() + text.size(), variants).ec != std::errc()) {
            return 2;
        }
    }
    if (argc == 2 || argc == 3) {
        for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    std::mt19937 random(1); // NOLINT: the same every time
    for (const auto& file : files) {
        std::ifstream stream(file, std::ios::binary);
        const Input input{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
        std::cout << file.filename().string() << ", " << input.size() << " bytes" << std::endl;
        LLVMFuzzerTestOneInput(input.data(), input.size());
        for (int i = 0; i < variants; ++i) {
            const Input variant = changed(input, random);
            LLVMFuzzerTestOneInput(variant.data(), variant.size());
        }
    }
    return files.empty() ? 2 : 0;
}
