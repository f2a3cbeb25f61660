#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <aolib/lighting/ConeTable.h>

#include "TestSkies.h"
#include "content/generated/Environments.h"
#include "shared/open_cone.h"

namespace aolib::lighting::test {
namespace {

ConeTable tableOf(const EnvironmentMap& map, const ConeTableOptions& options = {}) {
    Result<ConeTable> table = ConeTable::create(map, options);
    EXPECT_TRUE(table.ok()) << table.status().message();
    return *table;
}

/// The same mean by summing over texels.
glm::vec3 summed(const EnvironmentMap& map, const glm::vec3& axis, float share) {
    const float edge = std::sqrt(1.0F - share);
    glm::dvec3 sum(0.0);
    double weights = 0.0;
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const glm::vec2 place{(float(x) + 0.5F) / float(map.width),
                                  (float(y) + 0.5F) / float(map.height)};
            const float cosine = glm::dot(latLongDirection(place), axis);
            if (cosine > edge) {
                const double weight =
                    double(cosine) * std::cos(std::numbers::pi * (double(place.y) - 0.5));
                sum += weight * glm::dvec3(map.radiance[std::size_t(y * map.width + x)]);
                weights += weight;
            }
        }
    }
    return glm::vec3(sum / weights);
}

TEST(ConeTableTest, AnEvenSkyIsTheSameInEveryCone) {
    const ConeTable table = tableOf(evenSky(3.0F), {.columns = 16, .rows = 9, .apertures = 5});
    for (const glm::vec3& value : table.values()) {
        ASSERT_NEAR(value.r, 3.0F, 1e-4F);
    }
    EXPECT_NEAR(table.lookup({0.3F, -1.0F, 0.4F}, 0.37F).b, 3.0F, 1e-4F);
}

TEST(ConeTableTest, OpenSurfacesHaveTheIrradianceOfAnUpperSky) {
    // The form factor of half the sphere, for a normal at the angle t to its pole: (1 + cos t) / 2.
    // Bounds: rows of texels, and interpolation between the table's 32 rows.
    const ConeTable table = tableOf(upperSky());
    for (float degrees = 3.0F; degrees < 180.0F; degrees += 11.0F) {
        const float t = glm::radians(degrees);
        const glm::vec3 normal(std::sin(t) * 0.6F, std::cos(t), std::sin(t) * 0.8F);
        EXPECT_NEAR(table.lookup(normal, 1.0F).r, 0.5F * (1.0F + std::cos(t)), 0.004F) << degrees;
    }
}

TEST(ConeTableTest, TableEqualsASumOverTexels) {
    // At the table's own directions and apertures: only the map's texels at the cone's edge differ.
    const EnvironmentMap sky = findGeneratedEnvironment("studio")->build();
    const ConeTable table = tableOf(sky, {.columns = 16, .rows = 8, .apertures = 4});
    for (int layer = 1; layer < 4; ++layer) {
        const float share =
            std::pow(std::sin(0.5F * std::numbers::pi_v<float> * float(layer) / 3.0F), 2.0F);
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 16; x += 3) {
                const glm::vec3 axis =
                    latLongDirection({(float(x) + 0.5F) / 16.0F, float(y) / 7.0F});
                const glm::vec3 expected = summed(sky, axis, share);
                EXPECT_NEAR(glm::distance(table.lookup(axis, share), expected), 0.0F, 0.03F)
                    << layer << ' ' << y << ' ' << x;
            }
        }
    }
}

TEST(ConeTableTest, NarrowConesSeeWhatLiesAhead) {
    const ConeTable table = tableOf(upperSky(), {.columns = 8, .rows = 9, .apertures = 4});
    EXPECT_NEAR(table.lookup({0.2F, 1.0F, 0.1F}, 0.01F).r, 1.0F, 1e-5F);
    EXPECT_NEAR(table.lookup({0.2F, -1.0F, 0.1F}, 0.01F).r, 0.0F, 1e-5F);
}

TEST(ConeTableTest, ASurfaceUnderASlitIsLitByTheSlit) {
    // Bright within 33.75 degrees of straight up, where 24 of 128 rows end. A hole of that size
    // lets W = sin^2(33.75 degrees) = 0.3087 through.
    const EnvironmentMap sky = mapOf(256, 128, [](const glm::vec3& d) {
        return glm::vec3(d.y > std::cos(glm::radians(33.75F)) ? 4.0F : 0.0F);
    });
    const ConeTable table = tableOf(sky, {.columns = 16, .rows = 33, .apertures = 37});
    const glm::vec3 up(0.0F, 1.0F, 0.0F);
    // Between two apertures of the table, 2.5 degrees apart.
    EXPECT_NEAR(coneLight(table, up, up, 0.3087F).r, 1.2346F, 0.05F);
    EXPECT_NEAR(coneLight(table, up, up, 1.0F).r, 1.2346F, 0.002F) << "the rest is dark anyway";
    EXPECT_NEAR(coneLight(table, up, up, 0.1F).r, 0.4F, 0.01F) << "a smaller hole shows less";
    EXPECT_EQ(coneLight(table, up, up, 0.0F).r, 0.0F);
    EXPECT_EQ(coneLight(table, up, up, -0.1F).r, 0.0F) << "what interpolation may bring";
}

TEST(ConeTableTest, TheConeBesideAWallIsTiltedAndWide) {
    // Half of the hemisphere is open; the mean of its directions by the cosine is 2 / 3 up and, as
    // half a disc's, 2 / 3 * (2 / pi) to the side. W = 1/2.
    const glm::vec3 bent = glm::normalize(glm::vec3(2.0F / 3.0F * 2.0F / 3.14159F, 2.0F / 3.0F, 0));
    EXPECT_NEAR(shared::coneShare(0.5F, bent.y), 0.5F / bent.y, 1e-6F);
    EXPECT_EQ(shared::coneShare(0.9F, 0.001F), 1.0F);
    EXPECT_NEAR(shared::coneAperture(0.5F), 0.5F, 1e-6F) << "45 of 90 degrees";
}

TEST(ConeTableTest, OptionsOutOfRangeAreRefused) {
    EXPECT_FALSE(ConeTable::create(evenSky(1.0F), {.columns = 3}));
    EXPECT_FALSE(ConeTable::create(evenSky(1.0F), {.rows = 513}));
    EXPECT_FALSE(ConeTable::create(evenSky(1.0F), {.apertures = 1}));
    EXPECT_EQ(ConeTable::create({2, 2, {}}).status().code(), StatusCode::InvalidOption);
    EXPECT_TRUE(ConeTable::create(evenSky(1.0F, 1, 1))) << "the smallest map";
}

} // namespace
} // namespace aolib::lighting::test
