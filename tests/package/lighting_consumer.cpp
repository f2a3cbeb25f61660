// Asks what an even sky sends into an open surface: itself.
#include <iostream>

#include <aolib/lighting/ConeTable.h>
#include <aolib/lighting/EnvironmentLight.h>

int main() {
    aolib::lighting::EnvironmentMap sky{8, 4, {}};
    sky.radiance.assign(32, glm::vec3(2.0F));
    const auto cones = aolib::lighting::ConeTable::create(sky);
    if (!cones) {
        std::cout << cones.status().message() << '\n';
        return 1;
    }
    const glm::vec3 up(0.0F, 1.0F, 0.0F);
    const float light = aolib::lighting::coneLight(*cones, up, up, 1.0F).g;
    std::cout << light << '\n';
    return light > 1.99F && light < 2.01F && !aolib::lighting::environmentShader().empty() ? 0 : 1;
}
