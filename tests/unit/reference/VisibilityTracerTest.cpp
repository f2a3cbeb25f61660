#include "reference/VisibilityTracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "TestScenes.h"
#include "reference/ClosedForms.h"

namespace aolib {
namespace {

using test::sceneOf;
using test::tracing;
using test::visibilityAt;

const glm::dvec3 normal(0.0, 1.0, 0.0);

/// Receivers on the floor at growing distances from the wall.
std::vector<Receiver> floorReceivers(int count) {
    std::vector<Receiver> receivers;
    for (int i = 0; i < count; ++i) {
        receivers.push_back({{0.05 + 4.0 * i / count, 0.0, 0.37 * i}, normal});
    }
    return receivers;
}

VisibilityList traced(const RayScene& scene, const TraceSettings& settings,
                      std::span<const Receiver> receivers) {
    const Result<VisibilityTracer> tracer = VisibilityTracer::create(scene, settings);
    Result<VisibilityList> list = tracer->trace(receivers);
    EXPECT_TRUE(list) << list.status().message();
    return *list;
}

double rmse(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += (double{a[i]} - double{b[i]}) * (double{a[i]} - double{b[i]});
    }
    return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(VisibilityTracer, ScaleDoesNotMatter) {
    for (const double scale : {1e-4, 1.0, 1e6}) {
        SCOPED_TRACE(scale);
        const RayScene scene = sceneOf(test::floorAndWall(2.0, scale));
        const Receiver receiver{scale * glm::dvec3(1.0, 0.0, 0.0), normal};
        const auto none = visibilityAt(scene, receiver, tracing(65536));
        EXPECT_NEAR(1.0 - none.visibility, wallOcclusion(2.0, 1.0),
                    4.0 * std::sqrt(none.variance) + 2e-5);
        const auto step = visibilityAt(scene, receiver, tracing(4096, Falloff::Step, 1.5 * scale));
        const auto exp = visibilityAt(scene, receiver, tracing(4096, Falloff::Exp, 1.5 * scale));
        const RayScene unit = sceneOf(test::floorAndWall(2.0));
        const Receiver same{{1.0, 0.0, 0.0}, normal};
        // Equal random numbers: only rays within rounding of an edge may differ.
        EXPECT_NEAR(step.visibility,
                    visibilityAt(unit, same, tracing(4096, Falloff::Step, 1.5)).visibility, 0.001);
        EXPECT_NEAR(exp.visibility,
                    visibilityAt(unit, same, tracing(4096, Falloff::Exp, 1.5)).visibility, 0.001);
    }
}

/// At 1e5 floats are 1/128 apart, and so the floor may be that far below the receiver as far as
/// anyone can know: the default lift costs as much. A lift that is known costs nothing.
TEST(VisibilityTracer, FarTranslationDoesNotMatter) {
    const glm::dvec3 away(1e5, 1e5, -1e5);
    const RayScene scene = sceneOf(test::floorAndWall(2.0, 1.0, away));
    const glm::dvec3 position = away + glm::dvec3(1.0, 0.0, 0.0);
    const auto known = visibilityAt(scene, {position, normal, 1e-5}, tracing(65536));
    EXPECT_NEAR(1.0 - known.visibility, wallOcclusion(2.0, 1.0),
                4.0 * std::sqrt(known.variance) + 2e-5);
    const auto derived = visibilityAt(scene, {position, normal}, tracing(65536));
    EXPECT_NEAR(1.0 - derived.visibility, wallOcclusion(2.0, 1.0),
                4.0 * std::sqrt(derived.variance) + 0.01);
}

TEST(VisibilityTracer, EmptySceneIsOpen) {
    const RayScene scene = sceneOf({});
    for (const Falloff falloff : {Falloff::Step, Falloff::Exp, Falloff::Off}) {
        const auto estimate = visibilityAt(scene, {{1.0, 2.0, 3.0}, normal}, tracing(64, falloff));
        EXPECT_EQ(estimate.visibility, 1.0);
        EXPECT_EQ(estimate.variance, 0.0);
    }
}

TEST(VisibilityTracer, TrianglesWithoutAreaDoNotOcclude) {
    TriangleMesh mesh = test::floorAndWall(2.0);
    const RayScene clean = sceneOf(mesh);
    mesh.positions.insert(mesh.positions.end(), {{1, 1, 0}, {1, 1, 0}, {1, 1, 5}, {1, 1, 9}});
    mesh.indices.insert(mesh.indices.end(), {8, 8, 8, 8, 9, 10, 8, 10, 11});
    const RayScene littered = sceneOf(mesh);
    const Receiver receiver{{1.0, 0.0, 0.0}, normal};
    EXPECT_EQ(visibilityAt(clean, receiver, tracing(4096)).visibility,
              visibilityAt(littered, receiver, tracing(4096)).visibility);
}

TEST(VisibilityTracer, NormalsMayHaveAnyLength) {
    const RayScene scene = sceneOf(test::floorAndWall(2.0));
    EXPECT_EQ(visibilityAt(scene, {{1.0, 0.0, 0.0}, normal}, tracing(256)).visibility,
              visibilityAt(scene, {{1.0, 0.0, 0.0}, 1000.0 * normal}, tracing(256)).visibility);
}

/// What the tracer says of its noise is true: against 16 times the rays, whose own noise is an
/// eighth (stratification makes it fall faster than the root of the count), the RMSE is as stated.
TEST(VisibilityTracer, StatedNoiseIsTheActualNoise) {
    const RayScene scene = sceneOf(test::floorAndWall(2.0));
    const std::vector<Receiver> receivers = floorReceivers(400);
    for (const Falloff falloff : {Falloff::Step, Falloff::Exp}) {
        for (const int rays : {64, 512}) {
            const VisibilityList few = traced(scene, tracing(rays, falloff, 1.5), receivers);
            TraceSettings settings = tracing(16 * rays, falloff, 1.5);
            settings.seed = 1;
            const VisibilityList many = traced(scene, settings, receivers);
            const double ratio = rmse(few.visibility, many.visibility) / few.noise;
            EXPECT_GT(ratio, 1.0 / 1.3) << rays;
            EXPECT_LT(ratio, 1.3) << rays;
            EXPECT_LT(many.noise, few.noise / 4.0);
            RecordProperty("ratio", std::to_string(ratio));
        }
    }
}

TEST(VisibilityTracer, StratificationBeatsIndependentRays) {
    const RayScene scene = sceneOf(test::floorAndWall(2.0));
    const VisibilityList list = traced(scene, tracing(1024), floorReceivers(200));
    double binomial = 0.0;
    for (const float w : list.visibility) {
        binomial += double{w} * (1.0 - double{w}) / 1024.0 / 200.0;
    }
    EXPECT_LT(list.noise, 0.4 * std::sqrt(binomial));
}

TEST(VisibilityTracer, SameSeedSameResultWhateverTheThreads) {
    const RayScene scene = sceneOf(test::floorAndWall(2.0));
    const std::vector<Receiver> receivers = floorReceivers(100);
    TraceSettings settings = tracing(128, Falloff::Exp);
    settings.threads = 1;
    const VisibilityList one = traced(scene, settings, receivers);
    settings.threads = 5;
    const VisibilityList five = traced(scene, settings, receivers);
    EXPECT_EQ(one.visibility, five.visibility);
    EXPECT_EQ(one.standardError, five.standardError);
    EXPECT_EQ(one.noise, five.noise);
    settings.seed = 1;
    EXPECT_NE(traced(scene, settings, receivers).visibility, one.visibility);
}

TEST(VisibilityTracer, NeighboursDoNotShareTheirNoise) {
    const RayScene scene = sceneOf(test::floorAndWall(2.0));
    const std::vector<Receiver> receivers(64, Receiver{{1.0, 0.0, 0.0}, normal});
    const VisibilityList list = traced(scene, tracing(128), receivers);
    double mean = 0.0;
    for (const float w : list.visibility) {
        mean += double{w} / 64.0;
    }
    EXPECT_NEAR(1.0 - mean, wallOcclusion(2.0, 1.0), 4.0 * list.noise / 8.0);
    EXPECT_GT(rmse(list.visibility, std::vector<float>(64, static_cast<float>(mean))),
              list.noise / 2.0);
}

/// W under a smooth falloff is not counted in steps, so no two equal receivers agree by chance.
TEST(VisibilityTracer, EveryReceiverHasItsOwnNoise) {
    const RayScene scene = sceneOf(test::floorAndWall(2.0));
    const std::vector<Receiver> receivers(64, Receiver{{1.0, 0.0, 0.0}, normal});
    const VisibilityList list = traced(scene, tracing(128, Falloff::Exp), receivers);
    EXPECT_EQ(std::set<float>(list.visibility.begin(), list.visibility.end()).size(), 64U);
}

TEST(VisibilityTracer, CancelLeavesTheRestUntouched) {
    const RayScene scene = sceneOf(test::floorAndWall(2.0));
    const Result<VisibilityTracer> tracer = VisibilityTracer::create(scene, tracing(64));
    const Result<VisibilityList> list =
        tracer->trace(floorReceivers(50), [](double) { return false; });
    ASSERT_TRUE(list);
    EXPECT_FALSE(list->complete);
    EXPECT_EQ(list->visibility, std::vector<float>(50, -1.0F));
    EXPECT_EQ(list->noise, 0.0);
}

TEST(VisibilityTracer, ProgressEndsAtOne) {
    const RayScene scene = sceneOf(test::floorAndWall(2.0));
    const Result<VisibilityTracer> tracer = VisibilityTracer::create(scene, tracing(64));
    double last = -1.0;
    const Result<VisibilityList> list = tracer->trace(floorReceivers(50), [&](double fraction) {
        last = fraction;
        return true;
    });
    EXPECT_TRUE(list->complete);
    EXPECT_EQ(last, 1.0);
    EXPECT_EQ(std::ranges::count(list->visibility, -1.0F), 0);
}

TEST(VisibilityTracer, TracesAtLeastTheRaysAskedFor) {
    const RayScene scene = sceneOf({});
    for (const int rays : {2, 3, 8, 100, 1024, 16384}) {
        const int traced = VisibilityTracer::create(scene, tracing(rays))->raysTraced();
        EXPECT_GE(traced, rays);
        EXPECT_LE(traced, rays + 4 * std::sqrt(rays) + 4);
    }
}

TEST(VisibilityTracer, BadSettingsAndReceiversAreRefused) {
    const RayScene scene = sceneOf({});
    const auto code = [&](const TraceSettings& settings) {
        return VisibilityTracer::create(scene, settings).status().code();
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(code(tracing(1)), StatusCode::InvalidOption);
    EXPECT_EQ(code(tracing((1 << 24) + 1)), StatusCode::InvalidOption);
    EXPECT_EQ(code(tracing(64, Falloff::Step, 0.0)), StatusCode::InvalidOption);
    EXPECT_EQ(code(tracing(64, Falloff::Exp, nan)), StatusCode::InvalidOption);
    EXPECT_EQ(code(tracing(64, Falloff::Off, 0.0)), StatusCode::Ok);
    TraceSettings settings = tracing(64);
    settings.threads = -1;
    EXPECT_EQ(code(settings), StatusCode::InvalidOption);

    const Result<VisibilityTracer> tracer = VisibilityTracer::create(scene, tracing(64));
    const auto receiverCode = [&](const Receiver& receiver) {
        return tracer->trace(std::vector<Receiver>{receiver}).status().code();
    };
    EXPECT_EQ(receiverCode({{nan, 0.0, 0.0}, normal}), StatusCode::InvalidPosition);
    EXPECT_EQ(receiverCode({{0.0, 0.0, 0.0}, {0.0, nan, 0.0}}), StatusCode::InvalidNormal);
    EXPECT_EQ(receiverCode({{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}), StatusCode::InvalidNormal);
    EXPECT_EQ(receiverCode({{0.0, 0.0, 0.0}, normal, nan}), StatusCode::InvalidPosition);
}

} // namespace
} // namespace aolib
