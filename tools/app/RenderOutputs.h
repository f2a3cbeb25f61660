#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <aolib/Options.h>

#include "app/OutputFiles.h"
#include "app/RenderJob.h"
#include "app/TruthJob.h"

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

/// The flags that say which pictures "aolib render" writes, and where.
class RenderOutputs {
public:
    /// Adds the flags to a command. The object must outlive it.
    void attach(CLI::App& command);

    /// Checks the names before any work. @param withTruth  a truth is traced anyway.
    MaybeFailure announce(bool withTruth);
    /// Whether a picture was asked for that only a truth can give.
    bool needTruth() const { return !truth_.empty() || !difference_.empty(); }
    /// The debug views to render, one picture each.
    std::vector<DebugView> debugViews() const;

    /// Writes everything that was asked for, or nothing.
    MaybeFailure write(const RenderResult& result, const std::optional<Truth>& truth);
    std::vector<std::filesystem::path> written() const { return files_.files(); }

private:
    struct DebugPicture {
        std::string argument; ///< as given: "quality" or "quality=q.png"
        DebugView view = DebugView::Off;
        std::vector<std::filesystem::path> files;
    };
    /// One kind of picture: the file given by its flag, and those in the folder of --out.
    using Paths = std::vector<std::filesystem::path>;

    void parseDebug(const std::string& argument);
    MaybeFailure announceOne(const std::string& option, const std::string& given,
                             const std::vector<std::string>& extensions,
                             const std::vector<std::string>& namesInFolder, Paths& paths);
    MaybeFailure announceDebug();

    std::string folder_;
    std::string colour_;
    std::string ao_;
    std::string composite_;
    std::string truth_;
    std::string difference_;
    std::vector<DebugPicture> debug_;

    Paths colourFiles_;
    Paths aoFiles_;
    Paths compositeFiles_;
    Paths truthFiles_;
    Paths differenceFiles_;
    OutputFiles files_;
};

} // namespace aolib::app
