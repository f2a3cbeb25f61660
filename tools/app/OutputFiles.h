#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/Failure.h"
#include "image/Image.h"

namespace aolib::app {

/// The files a command writes: all of them, or none. Paths are checked before the work begins;
/// contents go to temporary names, and get their own when everything has succeeded.
class OutputFiles {
public:
    /// Announces a file named by `option`. Its folder must exist, unless it lies below one made by
    /// createFolder(). Fails on a missing folder, an extension other than the ones given (with
    /// the dot), a path that is a folder or was announced before.
    MaybeFailure announce(const std::string& option, const std::filesystem::path& file,
                          const std::vector<std::string>& extensions);
    /// Announces a folder, made by commit() if it does not exist. Fails where that is impossible.
    MaybeFailure createFolder(const std::string& option, const std::filesystem::path& folder);

    /// Gives an announced file its content: W as PFM, or in grey as PNG, by extension; a picture as
    /// PNG; bytes as they are.
    void put(const std::filesystem::path& file, FloatImage visibility);
    void put(const std::filesystem::path& file, ByteImage picture);
    void put(const std::filesystem::path& file, std::vector<std::uint8_t> bytes);

    /// Writes what was put. On failure nothing new is left behind.
    MaybeFailure commit();
    /// What was put, in that order.
    std::vector<std::filesystem::path> files() const;

private:
    /// Writes to the path given; an empty text means success, any other is the reason.
    using Writer = std::function<std::string(const std::filesystem::path&)>;
    struct Entry {
        std::filesystem::path file;
        Writer writer;
    };

    MaybeFailure makeFolders();
    MaybeFailure writeTemporaries();
    MaybeFailure renameTemporaries();
    void removeTraces();

    std::vector<std::filesystem::path> announced_;
    std::vector<std::filesystem::path> folders_;
    std::vector<std::filesystem::path> foldersMade_; ///< outermost first
    std::vector<Entry> entries_;
};

} // namespace aolib::app
