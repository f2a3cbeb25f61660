#include "content/generated/GeneratedScenes.h"

#include <algorithm>

namespace aolib {

const std::vector<GeneratedScene>& generatedScenes() {
    static const std::vector<GeneratedScene> scenes{
        {"town", "a walled town: streets, market square, church, arcade, houses, trees", buildTown,
         townCameras},
        {"room", "a furnished closed room with pillars, seen from inside", buildRoom, roomCameras},
        {"dome", "a domed rotunda with columns, ribs, coffers, lantern and mouldings", buildDome,
         domeCameras},
        {"cornell", "an open box with two blocks", buildCornell, cornellCameras},
        {"plane", "a lone plane: nothing is occluded", buildPlane, planeCameras},
        {"wall", "a floor beside a long wall of height 1", buildWall, wallCameras},
        {"disc", "a floor below a disc of radius 1 at height 1", buildDisc, discCameras},
        {"sphere-inside", "a closed sphere seen from inside", buildSphereInside,
         sphereInsideCameras},
    };
    return scenes;
}

const GeneratedScene* findGeneratedScene(std::string_view name) {
    const std::vector<GeneratedScene>& scenes = generatedScenes();
    const auto found = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const GeneratedScene& s) { return name == s.name; });
    return found == scenes.end() ? nullptr : &*found;
}

} // namespace aolib
