#include "TracedKinds.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "TracedView.h"

namespace aolib::test {

namespace {

constexpr int kRays = 400;

} // namespace

FloatImage TracedKinds::of(const CameraKind& camera, const glm::dvec2& offset) {
    const glm::dvec3 shift(-2.0 * offset.x / kWidth, -2.0 * offset.y / kHeight, 0.0);
    const glm::dmat4 projection = glm::translate(glm::dmat4(1.0), shift) * camera.traced;
    CameraKind plain = camera;
    plain.turn = glm::dmat4(1.0);
    const glm::dmat4 view = viewOf(plain);
    const glm::dmat4 key = projection * view;
    for (const auto& [known, image] : known_) {
        if (known == key) {
            return image;
        }
    }
    const Result<RayScene> scene = RayScene::create(model_.flattened());
    PictureSettings settings;
    settings.trace.rays = kRays;
    settings.trace.radius = 1.5;
    const Result<Picture> picture =
        tracePicture(*scene, {view, projection, kWidth, kHeight}, settings);
    EXPECT_TRUE(picture.ok()) << picture.status().message();
    known_.emplace_back(key, visibilityOf(*picture));
    return known_.back().second;
}

} // namespace aolib::test
