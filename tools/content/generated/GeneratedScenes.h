#pragma once

#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "content/Model.h"
#include "content/NamedCamera.h"

namespace aolib {

/// A scene that needs no file: the same triangles every time.
struct GeneratedScene {
    const char* name;
    const char* description; ///< one line
    Model (*build)();
    std::vector<NamedCamera> (*cameras)(); ///< at least two, the first is the scene's picture
};

/// Every generated scene, in the order in which tools list them.
const std::vector<GeneratedScene>& generatedScenes();

/// The scene of a name, or nullptr.
const GeneratedScene* findGeneratedScene(std::string_view name);

/// A walk through the town's streets at eye height (1.7 above the ground): the corners of a
/// polyline that stays at least half a unit away from every surface.
std::vector<glm::vec3> townWalk();

Model buildTown();
std::vector<NamedCamera> townCameras();
Model buildDome();
std::vector<NamedCamera> domeCameras();
Model buildRoom();
std::vector<NamedCamera> roomCameras();
Model buildCornell();
std::vector<NamedCamera> cornellCameras();
Model buildPlane();
std::vector<NamedCamera> planeCameras();
Model buildWall();
std::vector<NamedCamera> wallCameras();
Model buildDisc();
std::vector<NamedCamera> discCameras();
Model buildSphereInside();
std::vector<NamedCamera> sphereInsideCameras();

} // namespace aolib
