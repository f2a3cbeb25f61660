#include "viewer/CaseExport.h"

#include <array>
#include <charconv>
#include <system_error>

#include "content/generated/GeneratedScenes.h"
#include "viewer/OptionTexts.h"

namespace aolib::viewer {

namespace {

namespace fs = std::filesystem;

std::string numbers(const glm::vec3& v) {
    std::string text;
    for (int axis = 0; axis < 3; ++axis) {
        std::array<char, 32> digits{};
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), v[axis]).ptr;
        text += (axis == 0 ? "" : ",") + std::string(digits.data(), end);
    }
    return text;
}

std::string meshName(const std::string& scene, const fs::path& folder) {
    if (findGeneratedScene(scene) != nullptr) {
        return scene;
    }
    std::error_code error;
    const fs::path file = fs::absolute(scene, error);
    const fs::path relative = fs::relative(file, fs::absolute(folder, error), error);
    return error || relative.empty() ? file.string() : relative.string();
}

} // namespace

Case caseOf(const app::View& scene, const NamedCamera& camera, const glm::ivec2& pixels,
            const Options& options, const fs::path& folder) {
    Case result;
    result.mesh = meshName(scene.scene, folder);
    result.eye = camera.eye;
    result.target = camera.target;
    result.up = camera.up;
    result.fovyDeg = camera.fovyDeg;
    result.near = camera.near;
    result.far = camera.far;
    result.width = pixels.x;
    result.height = pixels.y;
    result.radius = options.radius;
    result.falloff = options.falloff;
    result.normals =
        scene.normals == host::SceneNormals::Model ? CaseNormals::Given : CaseNormals::Geometric;
    result.ground = scene.ground;
    result.folder = folder;
    return result;
}

std::string renderCommand(const std::string& caseFile, const Options& options,
                          const std::vector<CubeMapInfo>& cubeMaps) {
    Options held; // the defaults, and what the case holds
    held.radius = options.radius;
    held.falloff = options.falloff;
    Options wanted = options;
    wanted.frameBudget = held.frameBudget; // says when, not what
    wanted.cubeMaps.place = held.cubeMaps.place && cubeMaps.empty();
    held.cubeMaps.place = wanted.cubeMaps.place; // naming cube maps ends the placing by itself
    std::string command = "aolib render --case " + caseFile;
    const std::string flags = optionFlags(wanted, held);
    command += (flags.empty() ? "" : " ") + flags;
    if (options.backbone == Backbone::Cubemapped) {
        for (const CubeMapInfo& cubeMap : cubeMaps) {
            command += " --cube-map " + numbers(cubeMap.position);
        }
    }
    return command;
}

} // namespace aolib::viewer
