#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "content/NamedCamera.h"
#include "viewer/CubeMapGizmos.h"

namespace aolib::viewer {
namespace {

const glm::vec2 kPictureSize{800.0F, 600.0F};

std::vector<Gizmo> marks(const std::vector<glm::vec3>& positions) {
    NamedCamera camera;
    camera.eye = {0.0F, 0.0F, 10.0F};
    camera.target = {0.0F, 0.0F, 0.0F};
    std::vector<CubeMapInfo> cubeMaps;
    for (const glm::vec3& position : positions) {
        CubeMapInfo info;
        info.id = CubeMapId{static_cast<std::uint32_t>(cubeMaps.size() + 1)};
        info.position = position;
        cubeMaps.push_back(info);
    }
    return gizmosOf(cubeMaps,
                    projectionMatrix(camera, kPictureSize.x / kPictureSize.y) * viewMatrix(camera),
                    kPictureSize, 0.5F);
}

TEST(CubeMapGizmosTest, StandWhereTheCubeMapIsSeen) {
    const auto gizmos = marks({{0.0F, 0.0F, 0.0F}, {1.0F, 2.0F, 0.0F}});
    EXPECT_NEAR(glm::distance(gizmos[0].centre, 0.5F * kPictureSize), 0.0F, 1e-3F);
    EXPECT_GT(gizmos[1].centre.x, gizmos[0].centre.x);
    EXPECT_LT(gizmos[1].centre.y, gizmos[0].centre.y) << "up is a smaller y";
    EXPECT_EQ(gizmos[0].edges.size(), 24U) << "two ends for each of twelve edges";
}

TEST(CubeMapGizmosTest, NothingBehindTheEye) {
    const auto gizmos = marks({{0.0F, 0.0F, 20.0F}, {0.0F, 0.0F, 10.0F}});
    EXPECT_FALSE(gizmos[0].visible);
    EXPECT_TRUE(gizmos[0].edges.empty());
    EXPECT_LT(gizmos[1].edges.size(), 24U) << "half of it is behind";
}

TEST(CubeMapGizmosTest, TheNearestToTheMouseIsChosen) {
    const auto gizmos = marks({{0.0F, 0.0F, 0.0F}, {0.1F, 0.0F, 0.0F}, {0.0F, 0.0F, 30.0F}});
    EXPECT_EQ(gizmoAt(gizmos, gizmos[0].centre - glm::vec2(1.0F, 0.0F)), gizmos[0].id);
    EXPECT_EQ(gizmoAt(gizmos, gizmos[1].centre + glm::vec2(1.0F, 0.0F)), gizmos[1].id);
    EXPECT_FALSE(gizmoAt(gizmos, {50.0F, 50.0F}));
}

} // namespace
} // namespace aolib::viewer
