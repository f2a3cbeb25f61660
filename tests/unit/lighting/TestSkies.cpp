#include "TestSkies.h"

namespace aolib::lighting::test {

EnvironmentMap mapOf(int width, int height,
                     const std::function<glm::vec3(const glm::vec3& direction)>& radiance) {
    EnvironmentMap map{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            map.radiance.push_back(radiance(latLongDirection(
                {(float(x) + 0.5F) / float(width), (float(y) + 0.5F) / float(height)})));
        }
    }
    return map;
}

EnvironmentMap evenSky(float radiance, int width, int height) {
    return mapOf(width, height, [=](const glm::vec3&) { return glm::vec3(radiance); });
}

EnvironmentMap upperSky() {
    return mapOf(128, 64, [](const glm::vec3& d) { return glm::vec3(d.y > 0.0F ? 1.0F : 0.0F); });
}

} // namespace aolib::lighting::test
