#include "raytracing/CosineSampling.h"

#include <cmath>
#include <vector>

#include <glm/matrix.hpp>
#include <gtest/gtest.h>

namespace aolib {
namespace {

TEST(CosineSampling, ConcentricDiscMapsSquaresToRings) {
    EXPECT_EQ(concentricDisc({0.5, 0.5}), glm::dvec2(0.0));
    for (const double t : {0.05, 0.3, 0.5, 0.8, 1.0}) {
        const double ring = 0.6;
        for (const glm::dvec2& p :
             {glm::dvec2(0.8, 0.2 + 0.6 * t), glm::dvec2(0.2, 0.2 + 0.6 * t),
              glm::dvec2(0.2 + 0.6 * t, 0.8), glm::dvec2(0.2 + 0.6 * t, 0.2)}) {
            EXPECT_NEAR(glm::length(concentricDisc(p)), ring, 1e-12);
        }
    }
}

/// Neighbours stay neighbours, also across the diagonals where the formula changes.
TEST(CosineSampling, ConcentricDiscIsContinuous) {
    const double h = 1e-9;
    for (const double t : {0.1, 0.3, 0.7, 0.9}) {
        for (const double s : {t, 1.0 - t}) {
            const glm::dvec2 here = concentricDisc({t + h, s});
            EXPECT_NEAR(glm::distance(here, concentricDisc({t - h, s})), 0.0, 1e-7);
        }
    }
}

/// Equal areas of the square make equal areas of the disc: the Jacobian is pi everywhere.
TEST(CosineSampling, ConcentricDiscPreservesArea) {
    const double h = 1e-6;
    for (int i = 1; i < 40; ++i) {
        const glm::dvec2 p(std::fmod(0.618 * i, 1.0), std::fmod(0.414 * i, 1.0));
        const glm::dvec2 dx =
            (concentricDisc(p + glm::dvec2(h, 0)) - concentricDisc(p - glm::dvec2(h, 0))) / (2 * h);
        const glm::dvec2 dy =
            (concentricDisc(p + glm::dvec2(0, h)) - concentricDisc(p - glm::dvec2(0, h))) / (2 * h);
        EXPECT_NEAR(std::abs(dx.x * dy.y - dx.y * dy.x), std::numbers::pi, 1e-4) << i;
    }
}

/// For the density cos/pi the mean of z is 2/3 and that of z^2 is 1/2.
TEST(CosineSampling, DirectionsFollowTheCosine) {
    constexpr int side = 256;
    double sum = 0.0;
    double squares = 0.0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const glm::dvec3 d = cosineDirection({(x + 0.5) / side, (y + 0.5) / side});
            ASSERT_NEAR(glm::length(d), 1.0, 1e-12);
            ASSERT_GE(d.z, 0.0);
            sum += d.z;
            squares += d.z * d.z;
        }
    }
    EXPECT_NEAR(sum / (side * side), 2.0 / 3.0, 2e-4);
    EXPECT_NEAR(squares / (side * side), 0.5, 1e-4);
}

TEST(CosineSampling, BasisIsOrthonormalAndRightHanded) {
    for (const glm::dvec3& n :
         {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0),
          glm::normalize(glm::dvec3(1e-9, 1e-9, -1)), glm::normalize(glm::dvec3(-3, 2, 5))}) {
        const glm::dmat3 basis = basisAbout(n);
        EXPECT_EQ(basis[2], n);
        EXPECT_NEAR(glm::determinant(basis), 1.0, 1e-12);
        EXPECT_NEAR(glm::dot(basis[0], basis[1]), 0.0, 1e-12);
        EXPECT_NEAR(glm::dot(basis[0], n), 0.0, 1e-12);
        EXPECT_NEAR(glm::dot(basis[1], n), 0.0, 1e-12);
        EXPECT_NEAR(glm::length(basis[0]), 1.0, 1e-12);
    }
}

TEST(CosineSampling, SequencesAreUniformReproducibleAndUnlike) {
    RandomSequence a(7, 1);
    RandomSequence again(7, 1);
    RandomSequence b(7, 2);
    double mean = 0.0;
    double product = 0.0;
    constexpr int draws = 100000;
    for (int i = 0; i < draws; ++i) {
        const double x = a.next();
        const double y = b.next();
        ASSERT_EQ(x, again.next());
        ASSERT_GE(x, 0.0);
        ASSERT_LT(x, 1.0);
        mean += x / draws;
        product += (x - 0.5) * (y - 0.5) / draws;
    }
    EXPECT_NEAR(mean, 0.5, 0.004);     // four standard errors
    EXPECT_NEAR(product, 0.0, 0.0011); // no correlation, four standard errors
}

} // namespace
} // namespace aolib
