#include "bench/OpenedScene.h"

#include <filesystem>
#include <utility>

#include "bench/Fingerprint.h"
#include "content/Case.h"
#include "content/SceneSource.h"

namespace aolib::bench {

namespace {

/// What openScene() takes for an entry of the table; empty where there is no such file.
std::string sourceOf(const BenchScene& entry) {
    if (entry.kind == SceneKind::Generated) {
        return entry.name;
    }
    for (const std::filesystem::path& file : availableModels()) {
        if (file.stem() == entry.name) {
            return file.string();
        }
    }
    return "";
}

std::uint64_t fingerprintOf(const TriangleMesh& mesh) {
    Fingerprint fingerprint;
    fingerprint.add(std::span<const glm::vec3>(mesh.positions));
    fingerprint.add(std::span<const std::uint32_t>(mesh.indices));
    return fingerprint.value();
}

} // namespace

Result<OpenedScene, LoadError> openBenchScene(const BenchScene& entry) {
    const std::string source = sourceOf(entry);
    if (source.empty()) {
        return LoadError{entry.name + ": no model of this name; AOLIB_MODELS_DIR names the folder "
                                      "that has the models"};
    }
    Result<Model, LoadError> model = openScene(source);
    if (!model) {
        return model.error();
    }
    std::vector<NamedCamera> cameras = camerasFor(source, *model);
    const Bounds bounds = model->bounds();
    if (entry.ground) {
        addGround(*model, bounds.min.y);
    }
    TriangleMesh mesh = model->flattened();
    mesh.normals.clear(); // geometric normals everywhere
    const std::uint64_t fingerprint = fingerprintOf(mesh);
    Result<RayScene> rays = RayScene::create(std::move(mesh));
    if (!rays) {
        return LoadError{entry.name + ": " + rays.status().message()};
    }
    return OpenedScene{
        entry,       std::move(*model), std::move(cameras), static_cast<double>(bounds.diagonal()),
        fingerprint, std::move(*rays)};
}

} // namespace aolib::bench
