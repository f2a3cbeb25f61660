#include "viewer/SceneLoader.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <exception>
#include <filesystem>

namespace aolib::viewer {

namespace {

bool isCaseFile(const std::string& path) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    return ending == ".json";
}

Result<app::View, app::Failure> openAny(const std::string& nameOrPath) {
    try {
        return isCaseFile(nameOrPath) ? app::openCaseView(nameOrPath)
                                      : app::openSceneView(nameOrPath);
    } catch (const std::exception& error) {
        return app::badInput(nameOrPath + ": cannot be opened (" + error.what() + ")");
    }
}

} // namespace

void SceneLoader::open(const std::string& nameOrPath) {
    opening_ = std::async(std::launch::async, [nameOrPath, wake = wake_] {
        Result<app::View, app::Failure> opened = openAny(nameOrPath);
        wake();
        return opened;
    });
}

std::optional<Result<app::View, app::Failure>> SceneLoader::take() {
    if (!opening_.valid() ||
        opening_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        return std::nullopt;
    }
    return opening_.get();
}

} // namespace aolib::viewer
