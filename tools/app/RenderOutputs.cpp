#include "app/RenderOutputs.h"

#include <CLI/CLI.hpp>
#include <aolib/OptionFields.h>

#include "app/Comparison.h"

namespace aolib::app {

namespace {

const char* const kPicturesGroup = "Pictures";
const std::vector<std::string> kPicture{".png"};
const std::vector<std::string> kMeasured{".pfm", ".png"};

std::string debugName(DebugView view) {
    for (const auto& choice : kDebugViewChoices) {
        if (choice.value == view) {
            return std::string(choice.name);
        }
    }
    return "unknown";
}

std::string debugNames() {
    std::string names;
    for (const auto& choice : kDebugViewChoices) {
        if (choice.value != DebugView::Off) {
            names += std::string(choice.name) + ", ";
        }
    }
    return names + "all";
}

} // namespace

void RenderOutputs::attach(CLI::App& command) {
    const auto file = [&](const std::string& flag, std::string& path, const std::string& help) {
        command.add_option(flag, path, help)->type_name("FILE")->group(kPicturesGroup);
    };
    command.add_option("-o,--out", folder_, "write all of these into a folder, made if missing")
        ->type_name("FOLDER")
        ->group(kPicturesGroup);
    file("--colour", colour_, "the host's picture, .png");
    file("--ao", ao_, "visibility W, .pfm (floats, background -1) or .png");
    file("--composite", composite_, "the host's picture, darkened, .png");
    file("--truth", truth_, "ray-traced W, .pfm or .png");
    file("--difference", difference_, "W against ray tracing, .png: red too bright, blue too dark");
    command
        .add_option_function<std::vector<std::string>>(
            "--debug",
            [this](const std::vector<std::string>& arguments) {
                for (const std::string& argument : arguments) {
                    parseDebug(argument);
                }
            },
            "a debug view, as VIEW=FILE.png, or VIEW alone with --out: " + debugNames())
        ->type_name("VIEW[=FILE]")
        ->allow_extra_args(false)
        ->group(kPicturesGroup);
}

void RenderOutputs::parseDebug(const std::string& argument) {
    const std::size_t equals = argument.find('=');
    const std::string name = argument.substr(0, equals);
    bool known = false;
    for (const auto& choice : kDebugViewChoices) {
        if (choice.value != DebugView::Off && (name == choice.name || name == "all")) {
            debug_.push_back({argument, choice.value, {}});
            known = true;
        }
    }
    if (!known || (name == "all" && equals != std::string::npos)) {
        throw CLI::ValidationError("--debug " + argument + ": one of " + debugNames() +
                                   " is needed");
    }
    if (equals != std::string::npos) {
        debug_.back().files.emplace_back(argument.substr(equals + 1));
    }
}

std::vector<DebugView> RenderOutputs::debugViews() const {
    std::vector<DebugView> views;
    for (const DebugPicture& picture : debug_) {
        views.push_back(picture.view);
    }
    return views;
}

MaybeFailure RenderOutputs::announceOne(const std::string& option, const std::string& given,
                                        const std::vector<std::string>& extensions,
                                        const std::vector<std::string>& namesInFolder,
                                        Paths& paths) {
    if (!given.empty()) {
        if (MaybeFailure failure = files_.announce(option, given, extensions)) {
            return failure;
        }
        paths.emplace_back(given);
    }
    if (folder_.empty()) {
        return std::nullopt;
    }
    for (const std::string& name : namesInFolder) {
        const std::filesystem::path file = std::filesystem::path(folder_) / name;
        if (MaybeFailure failure = files_.announce("--out", file, extensions)) {
            return failure;
        }
        paths.push_back(file);
    }
    return std::nullopt;
}

MaybeFailure RenderOutputs::announce(bool withTruth) {
    if (!folder_.empty()) {
        if (MaybeFailure failure = files_.createFolder("--out", folder_)) {
            return failure;
        }
    }
    using Names = std::vector<std::string>;
    const bool truth = withTruth || needTruth();
    MaybeFailure failure = announceOne("--colour", colour_, kPicture, {"colour.png"}, colourFiles_);
    if (!failure) {
        failure = announceOne("--ao", ao_, kMeasured, {"ao.png", "ao.pfm"}, aoFiles_);
    }
    if (!failure) {
        failure =
            announceOne("--composite", composite_, kPicture, {"composite.png"}, compositeFiles_);
    }
    if (!failure) {
        failure = announceOne("--truth", truth_, kMeasured,
                              truth ? Names{"truth.png", "truth.pfm"} : Names{}, truthFiles_);
    }
    if (!failure) {
        failure = announceOne("--difference", difference_, kPicture,
                              truth ? Names{"difference.png"} : Names{}, differenceFiles_);
    }
    return failure ? failure : announceDebug();
}

MaybeFailure RenderOutputs::announceDebug() {
    for (DebugPicture& picture : debug_) {
        const std::string given = picture.files.empty() ? "" : picture.files.front().string();
        if (given.empty() && folder_.empty()) {
            return badInput("--debug " + picture.argument +
                            ": it needs a file (VIEW=FILE.png) or --out");
        }
        picture.files.clear();
        if (MaybeFailure failure =
                announceOne("--debug", given, kPicture,
                            {"debug-" + debugName(picture.view) + ".png"}, picture.files)) {
            return failure;
        }
    }
    return std::nullopt;
}

MaybeFailure RenderOutputs::write(const RenderResult& result, const std::optional<Truth>& truth) {
    const auto put = [this](const Paths& paths, const auto& picture) {
        for (const std::filesystem::path& path : paths) {
            files_.put(path, picture);
        }
    };
    put(colourFiles_, result.colour);
    put(aoFiles_, result.visibility);
    put(compositeFiles_, result.composite);
    if (truth) {
        put(truthFiles_, truth->visibility);
        const Result<ByteImage, Failure> difference =
            differenceFromTruth(result.visibility, *truth);
        if (!difference) {
            return difference.error();
        }
        put(differenceFiles_, *difference);
    }
    for (std::size_t i = 0; i < debug_.size(); ++i) {
        put(debug_[i].files, result.debugPictures[i]);
    }
    return files_.commit();
}

} // namespace aolib::app
