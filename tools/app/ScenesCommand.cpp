#include "app/Commands.h"

#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/Progress.h"
#include "app/Table.h"
#include "content/ModelFile.h"
#include "content/SceneSource.h"
#include "content/generated/GeneratedScenes.h"

namespace aolib::app {

namespace {

std::string cameraNames(const std::vector<NamedCamera>& cameras) {
    std::string names;
    for (const NamedCamera& camera : cameras) {
        names += (names.empty() ? "" : ", ") + camera.name;
    }
    return names;
}

void listGenerated(Progress& progress) {
    Table table({"generated scene", "triangles"});
    std::vector<std::string> remarks{"cameras; what it is"};
    progress.begin("building the generated scenes");
    for (const GeneratedScene& scene : generatedScenes()) {
        table.add({scene.name, grouped(scene.build().triangleCount())});
        remarks.push_back(cameraNames(scene.cameras()) + "; " + scene.description);
    }
    progress.pause();
    std::cout << table.text(remarks);
}

void listModels(Progress& progress) {
    Table table({"model file", "triangles"});
    std::vector<std::string> remarks{"cameras"};
    progress.begin("reading the models");
    for (const std::filesystem::path& file : availableModels()) {
        const Result<Model, LoadError> model = loadModel(file);
        table.add({file.string(), model ? grouped(model->triangleCount()) : "-"});
        remarks.push_back(model ? cameraNames(camerasFor(file.string(), *model))
                                : model.error().sentence);
    }
    progress.pause();
    if (remarks.size() > 1) {
        std::cout << '\n' << table.text(remarks);
    }
}

} // namespace

void addScenesCommand(CLI::App& program, MaybeFailure& failure) {
    CLI::App* command = program.add_subcommand(
        "scenes", "list the generated scenes, the models found, and cameras");
    command->footer("Models are looked for in the folder that the environment variable\n"
                    "AOLIB_MODELS_DIR names.");
    command->callback([&failure] {
        Progress progress;
        listGenerated(progress);
        listModels(progress);
        failure = std::nullopt;
    });
}

} // namespace aolib::app
