#include "app/Commands.h"

#include <filesystem>
#include <iostream>
#include <memory>
#include <system_error>

#include <CLI/CLI.hpp>

#include "app/BakeFlags.h"
#include "app/BakeJob.h"
#include "app/Interruption.h"
#include "app/Progress.h"
#include "app/UnusedOptions.h"

namespace aolib::app {

namespace {

namespace fs = std::filesystem;

bool isFolder(const std::string& path) {
    std::error_code code;
    return fs::is_directory(path, code);
}

MaybeFailure bakeAll(const BakeFlags& flags) {
    if (flags.out.empty() && flags.ao.empty() && flags.bentNormals.empty()) {
        return badInput("--out, --ao or --bent-normals is needed: nothing would be written");
    }
    const bool many = flags.inputs.size() > 1;
    if (many && (flags.out.empty() || !isFolder(flags.out) || !flags.ao.empty() ||
                 !flags.bentNormals.empty())) {
        return badInput("--out must be a folder that exists for several models, without --ao and "
                        "--bent-normals");
    }
    const Interruption interruption;
    Progress progress;
    for (const std::string& input : flags.inputs) {
        const std::string out =
            isFolder(flags.out) ? (fs::path(flags.out) / fs::path(input).stem()).string() + ".glb"
                                : flags.out;
        const Result<std::string, Failure> done = bakeModel(input, out, flags, progress);
        progress.pause();
        if (!done) {
            return done.error();
        }
        std::cout << input << (out.empty() ? "" : " -> " + out) << '\n' << *done;
    }
    return std::nullopt;
}

} // namespace

void addBakeCommand(CLI::App& program, MaybeFailure& failure) {
    const auto flags = std::make_shared<BakeFlags>();
    CLI::App* command =
        program.add_subcommand("bake", "compute occlusion once, into textures or vertices");
    flags->attach(*command);
    command->footer(
        "Examples:\n"
        "  aolib bake helmet.glb -o out.glb\n"
        "  aolib bake helmet.glb -o out.glb --size 2048 --rays 1024 --radius 10%\n"
        "  aolib bake bunny.glb -o out.glb --target vertex --fit least-squares\n"
        "  aolib bake uv-shapes --ao ao.png --bent-normals bent.png\n"
        "  aolib bake helmet.glb -o out.glb --method scatter --directions 1024\n"
        "  aolib bake cornell --target camera --camera front --ao ao.png --method shadow\n"
        "  aolib bake models/*.glb -o folder\n"
        "Ctrl-C stops it, and nothing half done is written.");
    command->callback([flags, command, &failure] {
        warnOf(unusedBakeFlags(*command, *flags));
        failure = bakeAll(*flags);
    });
}

} // namespace aolib::app
