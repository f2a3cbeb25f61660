#include "app/OutputFiles.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "image/FalseColour.h"
#include "image/FileContent.h"
#include "image/Pfm.h"
#include "image/Png.h"

namespace aolib::app {

namespace {

namespace fs = std::filesystem;

fs::path temporaryName(const fs::path& file) {
    fs::path name = file;
    name += ".part";
    return name;
}

/// The folder of a file, "." for a bare name.
fs::path folderOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

std::string reasonOf(const ImageOutcome& outcome) {
    return outcome ? outcome->message : std::string();
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : " or ") + word;
    }
    return text;
}

} // namespace

MaybeFailure OutputFiles::announce(const std::string& option, const fs::path& file,
                                   const std::vector<std::string>& extensions) {
    const std::string subject = option + " " + file.string() + ": ";
    if (std::find(extensions.begin(), extensions.end(), file.extension().string()) ==
        extensions.end()) {
        return badInput(subject + "the name must end in " + joined(extensions));
    }
    if (std::find(announced_.begin(), announced_.end(), file) != announced_.end()) {
        return badInput(subject + "another output has this name");
    }
    std::error_code error;
    const fs::path folder = folderOf(file);
    if (std::find(folders_.begin(), folders_.end(), folder) == folders_.end() &&
        !fs::is_directory(folder, error)) {
        return badInput(subject + "there is no folder " + folder.string());
    }
    if (fs::is_directory(file, error)) {
        return badInput(subject + "this is a folder");
    }
    announced_.push_back(file);
    return std::nullopt;
}

MaybeFailure OutputFiles::createFolder(const std::string& option, const fs::path& folder) {
    std::error_code error;
    for (fs::path part = folder; !part.empty(); part = part.parent_path()) {
        if (fs::exists(part, error)) {
            if (!fs::is_directory(part, error)) {
                return badInput(option + " " + folder.string() + ": " + part.string() +
                                " is not a folder");
            }
            break;
        }
        if (part == part.parent_path()) {
            break;
        }
    }
    folders_.push_back(folder);
    return std::nullopt;
}

void OutputFiles::put(const fs::path& file, FloatImage visibility) {
    if (file.extension() == ".pfm") {
        entries_.push_back({file, [image = std::move(visibility)](const fs::path& to) {
                                return reasonOf(writePfm(to, image));
                            }});
    } else {
        put(file, greyPicture(visibility));
    }
}

void OutputFiles::put(const fs::path& file, ByteImage picture) {
    entries_.push_back({file, [image = std::move(picture)](const fs::path& to) {
                            return reasonOf(writePng(to, image));
                        }});
}

void OutputFiles::put(const fs::path& file, std::vector<std::uint8_t> bytes) {
    entries_.push_back({file, [content = std::move(bytes)](const fs::path& to) {
                            return reasonOf(writeFile(to, content));
                        }});
}

MaybeFailure OutputFiles::commit() {
    MaybeFailure failure = makeFolders();
    if (!failure) {
        failure = writeTemporaries();
    }
    if (!failure) {
        failure = renameTemporaries();
    }
    if (failure) {
        removeTraces();
    }
    return failure;
}

MaybeFailure OutputFiles::makeFolders() {
    for (const fs::path& folder : folders_) {
        std::vector<fs::path> missing;
        std::error_code error;
        for (fs::path part = folder; !part.empty() && !fs::exists(part, error);
             part = part.parent_path()) {
            missing.push_back(part);
        }
        std::reverse(missing.begin(), missing.end());
        for (const fs::path& part : missing) {
            if (fs::create_directory(part, error)) {
                foldersMade_.push_back(part);
            } else if (error) {
                return badInput(part.string() + " cannot be made: " + error.message());
            }
        }
    }
    return std::nullopt;
}

MaybeFailure OutputFiles::writeTemporaries() {
    for (const Entry& entry : entries_) {
        if (const std::string reason = entry.writer(temporaryName(entry.file)); !reason.empty()) {
            return Failure{ExitCode::Failed, reason};
        }
    }
    return std::nullopt;
}

MaybeFailure OutputFiles::renameTemporaries() {
    for (const Entry& entry : entries_) {
        std::error_code error;
        fs::rename(temporaryName(entry.file), entry.file, error);
        if (error) {
            return Failure{ExitCode::Failed,
                           entry.file.string() + " cannot be replaced: " + error.message()};
        }
    }
    return std::nullopt;
}

void OutputFiles::removeTraces() {
    std::error_code ignored;
    for (const Entry& entry : entries_) {
        fs::remove(temporaryName(entry.file), ignored);
    }
    for (auto folder = foldersMade_.rbegin(); folder != foldersMade_.rend(); ++folder) {
        fs::remove(*folder, ignored); // fails, as it should, where it is not empty
    }
}

std::vector<fs::path> OutputFiles::files() const {
    std::vector<fs::path> names;
    for (const Entry& entry : entries_) {
        names.push_back(entry.file);
    }
    return names;
}

} // namespace aolib::app
