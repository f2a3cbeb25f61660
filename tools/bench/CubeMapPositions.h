#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "bench/OpenedScene.h"
#include "bench/Receivers.h"

namespace aolib::bench {

/// Where `count` cube maps go: the first at the eye, the others on the way to what it sees in the
/// middle of each ninth of the picture; halfway, then for every nine more half as far.
std::vector<glm::vec3> cubeMapPositions(const OpenedScene& scene, const NamedCamera& camera,
                                        const PictureSize& size, int count);

} // namespace aolib::bench
