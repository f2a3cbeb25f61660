#pragma once

#include <aolib/bake/AbstractBaker.h>
#include <aolib/bake/BakeScene.h>

#include "content/generated/UvShapes.h"

namespace aolib::bake::test {

/// A mesh as a surface to bake.
Surface surfaceOf(const UvMesh& mesh, int map = 0);

/// One surface by itself.
BakeScene sceneOf(const UvMesh& mesh);

/// The unit square y = 0, facing up, u along x and v along -z, from (0, 0) to (1, -1) in (x, z).
UvMesh unitFloor(int cells);

/// The floor 0 <= x <= 1, -1 <= z <= 0 of map 0, and a wall that only occludes: x = 0, as high as
/// said, so long that it counts as endless.
BakeScene floorBesideWall(double height, int cells = 1);

/// The wall reaches 4 beyond the floor to both sides, not further: pictures from the light hold all
/// of it. Seen from the floor's middle its ends cover less than 1% of the hemisphere.
BakeScene floorBesideShortWall();

/// Two charts that meet at u = 0.4 of one map: the left one open, the right one closed by a lid.
BakeScene openBesideClosedChart();

/// Values of a baker, which must succeed.
BakedMap onlyMap(AbstractBaker& baker, int size, int padding = 0, bool fill = false);
BakedMap bakeRays(BakeScene scene, int rays, int size);

} // namespace aolib::bake::test
