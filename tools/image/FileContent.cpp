#include "image/FileContent.h"

#include <atomic>
#include <cerrno>
#include <fstream>
#include <ios>
#include <random>
#include <string>
#include <system_error>

namespace aolib {

namespace {

namespace fs = std::filesystem;

ImageError failed(const fs::path& file, const std::string& what, const std::string& reason) {
    return {file.string() + ": " + what + ": " + reason};
}

/// What the system said last, or that it said nothing.
std::string lastReason() {
    return errno == 0 ? "unknown reason" : std::generic_category().message(errno);
}

/// A name of this process's and this call's own, beside the file.
fs::path temporaryName(const fs::path& file) {
    static const unsigned process = std::random_device{}();
    static std::atomic<unsigned> calls{0};
    fs::path name = file;
    name += ".part-" + std::to_string(process) + "-" + std::to_string(calls++);
    return name;
}

} // namespace

Result<std::vector<std::uint8_t>, ImageError> readFile(const fs::path& file) {
    std::error_code code;
    if (fs::is_directory(file, code)) {
        return failed(file, "cannot be read", "it is a folder");
    }
    errno = 0;
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        return failed(file, "cannot be opened", lastReason());
    }
    const std::uintmax_t size = fs::file_size(file, code);
    if (code) {
        return failed(file, "its size cannot be read", code.message());
    }
    std::vector<std::uint8_t> content(static_cast<std::size_t>(size));
    stream.read(reinterpret_cast<char*>(content.data()), static_cast<std::streamsize>(size));
    if (!stream) {
        return failed(file, "cannot be read", lastReason());
    }
    return content;
}

ImageOutcome writeFile(const fs::path& file, std::span<const std::uint8_t> content) {
    const fs::path temporary = temporaryName(file);
    std::error_code code;
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
    if (!stream) {
        return failed(file, "cannot be written", lastReason());
    }
    stream.write(reinterpret_cast<const char*>(content.data()),
                 static_cast<std::streamsize>(content.size()));
    stream.close();
    if (!stream) {
        const ImageError error = failed(file, "cannot be written", lastReason());
        fs::remove(temporary, code);
        return error;
    }
    fs::rename(temporary, file, code);
    if (code) {
        const ImageError error = failed(file, "cannot be replaced", code.message());
        fs::remove(temporary, code);
        return error;
    }
    return std::nullopt;
}

} // namespace aolib
