#include "BakeScenes.h"

#include <utility>

#include <gtest/gtest.h>

namespace aolib::bake::test {

Surface surfaceOf(const UvMesh& mesh, int map) {
    return {mesh.positions, mesh.normals, mesh.uvs, mesh.indices, map};
}

BakeScene sceneOf(const UvMesh& mesh) {
    BakeScene scene;
    scene.surfaces.push_back(surfaceOf(mesh));
    return scene;
}

UvMesh unitFloor(int cells) {
    UvMesh mesh;
    addUvQuad(mesh, glm::vec3(0.0F), {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -1.0F}, cells);
    return mesh;
}

BakeScene floorBesideWall(double height, int cells) {
    BakeScene scene = sceneOf(unitFloor(cells));
    UvMesh wall;
    const auto high = static_cast<float>(height);
    addUvQuad(wall, {0.0F, 0.0F, 500.0F}, {0.0F, 0.0F, -1000.0F}, {0.0F, high, 0.0F}, 1);
    scene.surfaces.push_back(surfaceOf(wall, -1));
    return scene;
}

BakeScene floorBesideShortWall() {
    BakeScene scene = sceneOf(unitFloor(1));
    UvMesh wall;
    addUvQuad(wall, {0.0F, 0.0F, 3.5F}, {0.0F, 0.0F, -8.0F}, {0.0F, 0.5F, 0.0F}, 1);
    scene.surfaces.push_back(surfaceOf(wall, -1));
    return scene;
}

BakeScene openBesideClosedChart() {
    UvMesh open;
    addUvQuad(open, {0, 0, 0}, {1, 0, 0}, {0, 0, -1}, 1, {{0.0F, 0.0F}, {0.4F, 1.0F}});
    UvMesh closed;
    addUvQuad(closed, {3, 0, 0}, {1, 0, 0}, {0, 0, -1}, 1, {{0.4F, 0.0F}, {1.0F, 1.0F}});
    UvMesh lid;
    addUvQuad(lid, {2.0F, 0.05F, 1.0F}, {3, 0, 0}, {0, 0, -3}, 1);
    BakeScene scene = sceneOf(open);
    scene.surfaces.push_back(surfaceOf(closed, 0));
    scene.surfaces.push_back(surfaceOf(lid, -1));
    return scene;
}

BakedMap onlyMap(AbstractBaker& baker, int size, int padding, bool fill) {
    MapOptions options;
    options.width = size;
    options.height = size;
    options.padding = padding;
    options.fill = fill;
    auto maps = baker.bakeMaps(options, {});
    EXPECT_TRUE(maps.ok()) << maps.status().message();
    if (!maps || maps->size() != 1) {
        ADD_FAILURE() << "one map is wanted";
        return {};
    }
    return std::move(maps->front());
}

BakedMap bakeRays(BakeScene scene, int rays, int size) {
    RayOptions options;
    options.rays = rays;
    auto baker = createRayBaker(std::move(scene), options);
    EXPECT_TRUE(baker.ok()) << baker.status().message();
    return baker ? onlyMap(**baker, size) : BakedMap{};
}

} // namespace aolib::bake::test
