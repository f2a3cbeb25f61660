// Bakes the vertices of a lone triangle: nothing hides the sky from it.
#include <iostream>

#include <aolib/bake/AbstractBaker.h>

int main() {
    aolib::bake::BakeScene scene;
    aolib::bake::Surface& surface = scene.surfaces.emplace_back();
    surface.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    surface.indices = {0, 1, 2};
    auto baker = aolib::bake::createRayBaker(scene, {});
    if (!baker) {
        std::cout << baker.status().message() << '\n';
        return 1;
    }
    const auto baked = (*baker)->bakeVertices({}, {});
    if (!baked) {
        std::cout << baked.status().message() << '\n';
        return 1;
    }
    const bool open = baked->size() == 1 && baked->at(0).visibility.at(0) > 0.99F;
    std::cout << (open ? "open\n" : "not open\n");
    return open ? 0 : 1;
}
