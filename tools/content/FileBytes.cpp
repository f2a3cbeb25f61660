#include "content/FileBytes.h"

#include <cstdint>
#include <fstream>
#include <system_error>

namespace aolib {
namespace {

constexpr std::uintmax_t largestFile = std::uintmax_t{1} << 31;

} // namespace

Result<std::string, LoadError> readFileBytes(const std::filesystem::path& file) {
    const std::string name = file.string();
    std::error_code code;
    const std::filesystem::file_status status = std::filesystem::status(file, code);
    if (!std::filesystem::exists(status)) {
        return LoadError{name + ": there is no such file"};
    }
    if (!std::filesystem::is_regular_file(status)) {
        return LoadError{name + ": not a regular file"};
    }
    const std::uintmax_t size = std::filesystem::file_size(file, code);
    if (code) {
        return LoadError{name + ": its size cannot be read (" + code.message() + ")"};
    }
    if (size > largestFile) {
        return LoadError{name + ": larger than 2 GiB (" + std::to_string(size) + " bytes)"};
    }
    std::ifstream stream(file, std::ios::binary);
    std::string bytes(static_cast<std::size_t>(size), '\0');
    if (!stream || !stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
        return LoadError{name + ": cannot be read"};
    }
    return bytes;
}

} // namespace aolib
