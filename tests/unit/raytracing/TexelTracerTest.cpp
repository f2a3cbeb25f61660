#include <aolib/RayTracing.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "TestScenes.h"
#include "raytracing/RequestTracer.h"

namespace aolib {
namespace {

constexpr double longTime = 6e4;           ///< milliseconds
constexpr int endlessRays = (1 << 30) - 1; ///< hours of work

std::unique_ptr<AbstractTexelTracer> tracerOf(int threads) {
    auto tracer = createTexelTracer(threads);
    EXPECT_TRUE(tracer) << tracer.status().message();
    return std::move(*tracer);
}

std::uint64_t setScene(AbstractTexelTracer& tracer, const TriangleMesh& mesh) {
    return tracer.setScene(mesh.positions, mesh.indices, mesh.normals);
}

/// Tile number `key` of a cube map of 32 x 32 texels, 16 tiles a face.
TexelRequest tile(std::uint64_t key, int rays = 16) {
    TexelRequest request;
    request.key = key;
    request.centre = {2.0F, 1.0F, 0.0F};
    request.faceSize = 32;
    request.face = static_cast<int>(key / 16 % 6);
    request.x = static_cast<int>(key % 4) * 8;
    request.y = static_cast<int>(key / 4 % 4) * 8;
    request.width = 8;
    request.height = 8;
    request.rays = rays;
    request.radius = 1.5F;
    return request;
}

std::vector<TexelRequest> tiles(std::uint64_t begin, std::uint64_t end) {
    std::vector<TexelRequest> queue;
    for (std::uint64_t key = begin; key < end; ++key) {
        queue.push_back(tile(key));
    }
    return queue;
}

/// Everything that is asked for and not yet taken.
std::vector<TracedTexels> takeAll(AbstractTexelTracer& tracer) {
    std::vector<TracedTexels> all;
    while (tracer.pending() > 0) {
        EXPECT_TRUE(tracer.wait(longTime));
        for (TracedTexels& texels : tracer.take(3)) {
            all.push_back(std::move(texels));
        }
    }
    return all;
}

TEST(TexelTracer, ResultsDoNotDependOnThreads) {
    TriangleMesh mesh = test::floorAndWall(2.0);
    mesh.normals.assign(mesh.positions.size(), glm::vec3(0.6F, 0.8F, 0.0F));
    const RayScene scene = test::sceneOf(mesh);
    for (const int threads : {1, 4}) {
        const auto tracer = tracerOf(threads);
        setScene(*tracer, mesh);
        tracer->request(tiles(0, 96));
        const std::vector<TracedTexels> all = takeAll(*tracer);
        ASSERT_EQ(all.size(), 96U);
        for (const TracedTexels& texels : all) {
            const auto alone = traceRequest(scene, texels.request, [] { return true; });
            EXPECT_EQ(texels.visibility, alone->visibility);
            EXPECT_EQ(texels.distance, alone->distance);
            EXPECT_EQ(texels.normal, alone->normal);
        }
        EXPECT_TRUE(tracer->status());
    }
}

TEST(TexelTracer, OneWorkerServesInTheQueuesOrder) {
    const auto tracer = tracerOf(1);
    setScene(*tracer, test::floorAndWall(2.0));
    std::vector<TexelRequest> queue = tiles(0, 20);
    std::ranges::reverse(queue);
    tracer->request(queue);
    const std::vector<TracedTexels> all = takeAll(*tracer);
    ASSERT_EQ(all.size(), 20U);
    for (std::size_t i = 0; i < 20; ++i) {
        EXPECT_EQ(all[i].request.key, 19 - i);
    }
}

TEST(TexelTracer, EveryRequestIsAnsweredOnce) {
    const auto tracer = tracerOf(3);
    setScene(*tracer, test::floorAndWall(2.0));
    tracer->request(tiles(0, 60));
    EXPECT_EQ(tracer->pending(), 60U);
    std::map<std::uint64_t, int> times;
    for (const TracedTexels& texels : takeAll(*tracer)) {
        ++times[texels.request.key];
    }
    EXPECT_EQ(times.size(), 60U);
    EXPECT_TRUE(std::ranges::all_of(times, [](const auto& entry) { return entry.second == 1; }));
}

TEST(TexelTracer, TakeGivesAtMostWhatIsAskedFor) {
    const auto tracer = tracerOf(1);
    setScene(*tracer, test::floorAndWall(2.0));
    tracer->request(tiles(0, 5));
    while (tracer->take(0).empty() && tracer->pending() > 0 && tracer->wait(longTime)) {
        std::this_thread::yield();
        if (tracer->take(2).size() == 2) {
            break;
        }
        tracer->request(tiles(0, 5));
    }
    EXPECT_LE(tracer->pending(), 8U);
    takeAll(*tracer);
    EXPECT_TRUE(tracer->take(10).empty());
}

TEST(TexelTracer, ANewQueueReplacesTheOld) {
    constexpr std::uint64_t kOld = 100000; // not done before this thread has its turn again
    const auto tracer = tracerOf(1);
    setScene(*tracer, test::floorAndWall(2.0));
    std::vector<TexelRequest> old = tiles(0, kOld);
    tracer->request(old);
    ASSERT_TRUE(tracer->wait(longTime));
    tracer->request(tiles(kOld, kOld + 4));
    // What was finished, at most one that was begun, and the new ones.
    const std::vector<TracedTexels> all = takeAll(*tracer);
    EXPECT_LT(all.size(), kOld);
    ASSERT_GE(all.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(all[all.size() - 4 + i].request.key, kOld + i);
    }
    tracer->request(old);
    tracer->request({});
    const std::size_t left = tracer->pending(); // as above, however long this thread slept
    EXPECT_LT(left, kOld);
    EXPECT_EQ(takeAll(*tracer).size(), left) << "of the old queue nothing else is begun";
}

TEST(TexelTracer, WaitEndsAtItsLimitOrWhenNothingIsLeft) {
    const auto tracer = tracerOf(1);
    EXPECT_TRUE(tracer->wait(longTime));
    setScene(*tracer, test::floorAndWall(2.0));
    EXPECT_TRUE(tracer->wait(longTime));
    tracer->request({tile(50, endlessRays)});
    EXPECT_FALSE(tracer->wait(1.0));
    EXPECT_FALSE(tracer->wait(0.0));
    EXPECT_FALSE(tracer->wait(-1.0));
    EXPECT_FALSE(tracer->wait(std::numeric_limits<double>::quiet_NaN()));
    EXPECT_EQ(tracer->pending(), 1U);
}

/// Without the checks between pieces these would take hours.
TEST(TexelTracer, EndsInTheMiddleOfItsWork) {
    const auto tracer = tracerOf(4);
    setScene(*tracer, test::floorAndWall(2.0));
    tracer->request({tile(50, endlessRays), tile(51, endlessRays), tile(16, endlessRays)});
    EXPECT_FALSE(tracer->wait(20.0));
}

using ScenesByNumber = std::map<std::uint64_t, const RayScene*>;

void expectItsScene(const TracedTexels& texels, const ScenesByNumber& scenes) {
    const auto found = scenes.find(texels.scene);
    ASSERT_NE(found, scenes.end()) << texels.scene;
    EXPECT_EQ(texels.visibility,
              traceRequest(*found->second, texels.request, [] { return true; })->visibility);
}

TEST(TexelTracer, ANewSceneLeavesRequestsAndResults) {
    const auto tracer = tracerOf(2);
    const RayScene floor = test::sceneOf(test::floorAndWall(2.0));
    const RayScene box = test::sceneOf(test::box());
    const std::uint64_t first = setScene(*tracer, test::floorAndWall(2.0));
    tracer->request(tiles(0, 40));
    ASSERT_TRUE(tracer->wait(longTime));
    const std::uint64_t second = setScene(*tracer, test::box());
    const ScenesByNumber scenes{{first, &floor}, {second, &box}};
    EXPECT_GT(second, first);
    EXPECT_EQ(tracer->pending(), 40U);
    const std::vector<TracedTexels> all = takeAll(*tracer);
    EXPECT_EQ(all.size(), 40U);
    EXPECT_EQ(all.front().scene, first);
    std::uint64_t latest = 0;
    for (const TracedTexels& texels : all) {
        expectItsScene(texels, scenes);
        latest = texels.scene;
    }
    while (latest != second) { // the last one is there as soon as there is nothing to trace
        tracer->request({tile(3)});
        latest = takeAll(*tracer).back().scene;
    }
}

TEST(TexelTracer, ScenesMayChangeAtAnyTime) {
    const auto tracer = tracerOf(3);
    const std::array meshes{test::sphere(5.0), test::floorAndWall(2.0)};
    const std::array traceable{test::sceneOf(meshes[0]), test::sceneOf(meshes[1])};
    ScenesByNumber scenes;
    std::vector<TracedTexels> all;
    const auto take = [&] {
        for (TracedTexels& texels : tracer->take(100)) {
            all.push_back(std::move(texels));
        }
    };
    for (std::size_t i = 0; i < 40; ++i) {
        scenes[setScene(*tracer, meshes[i % 2])] = &traceable[i % 2];
        tracer->request(tiles(0, 30));
        if (i % 3 == 0) {
            tracer->wait(0.5);
            take();
        }
    }
    for (TracedTexels& texels : takeAll(*tracer)) {
        all.push_back(std::move(texels));
    }
    EXPECT_GE(all.size(), 30U);
    for (const TracedTexels& texels : all) {
        expectItsScene(texels, scenes);
    }
}

/// A scene in every millisecond, each of which takes longer to build.
TEST(TexelTracer, ScenesThatComeFasterThanTheyAreBuiltKeepNothingFromBeingTraced) {
    const auto tracer = tracerOf(1);
    const TriangleMesh mesh = test::sphere(5.0);
    std::uint64_t newest = setScene(*tracer, mesh);
    std::uint64_t traced = 0;
    std::size_t results = 0;
    for (int i = 0; i < 20000 && (results < 100 || traced < 3); ++i) {
        tracer->request(tiles(0, 30));
        tracer->wait(1.0);
        for (const TracedTexels& texels : tracer->take(100)) {
            ++results;
            traced = texels.scene;
        }
        newest = setScene(*tracer, mesh);
    }
    EXPECT_GE(results, 100U);
    EXPECT_GE(traced, 3U) << "nor are they left out for ever";
    EXPECT_LT(traced, newest);
}

TEST(TexelTracer, MayBeAskedFromManyThreads) {
    const auto tracer = tracerOf(2);
    setScene(*tracer, test::floorAndWall(2.0));
    {
        std::vector<std::jthread> hosts;
        for (int host = 0; host < 3; ++host) {
            hosts.emplace_back([&tracer, host] {
                for (int i = 0; i < 50; ++i) {
                    tracer->request(tiles(0, 8));
                    tracer->take(2);
                    tracer->wait(0.1);
                    tracer->status();
                    if (host == 0 && i % 10 == 0) {
                        setScene(*tracer, test::box());
                    }
                }
            });
        }
    }
    takeAll(*tracer);
    EXPECT_TRUE(tracer->status()) << tracer->status().message();
}

TEST(TexelTracer, ARejectedSceneSaysWhy) {
    const auto tracer = tracerOf(1);
    TriangleMesh mesh = test::box();
    mesh.positions[5].y = std::numeric_limits<float>::quiet_NaN();
    const auto rejected = [&](const TriangleMesh& bad) {
        setScene(*tracer, bad);
        tracer->request(tiles(0, 3));
        EXPECT_TRUE(tracer->wait(longTime));
        EXPECT_EQ(tracer->pending(), 0U);
        return tracer->status().code();
    };
    EXPECT_EQ(rejected(mesh), StatusCode::InvalidPosition);
    mesh = test::box();
    mesh.indices[4] = 1000;
    EXPECT_EQ(rejected(mesh), StatusCode::InvalidIndex);
    mesh = test::box();
    mesh.indices.pop_back();
    EXPECT_EQ(rejected(mesh), StatusCode::IncompletePrimitive);
    mesh = test::box();
    mesh.normals.assign(mesh.positions.size() - 1, glm::vec3(0.0F));
    EXPECT_EQ(rejected(mesh), StatusCode::InvalidNormal);
    mesh.normals.emplace_back(std::numeric_limits<float>::infinity());
    EXPECT_EQ(rejected(mesh), StatusCode::InvalidNormal);
    setScene(*tracer, test::box());
    EXPECT_TRUE(tracer->status());
    tracer->request(tiles(0, 3));
    EXPECT_EQ(takeAll(*tracer).size(), 3U);
}

TEST(TexelTracer, BadRequestsAreLeftOut) {
    const auto tracer = tracerOf(1);
    tracer->request(tiles(0, 3));
    EXPECT_EQ(tracer->status().code(), StatusCode::NoScene);
    EXPECT_EQ(tracer->pending(), 0U);
    setScene(*tracer, test::box());
    std::vector<TexelRequest> queue = tiles(0, 3);
    queue[1].face = 7;
    tracer->request(queue);
    EXPECT_EQ(tracer->pending(), 2U);
    EXPECT_EQ(tracer->status().code(), StatusCode::InvalidOption);
    const std::vector<TracedTexels> all = takeAll(*tracer);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[1].request.key, 2U);
}

TEST(TexelTracer, ThreadsOutOfRangeAreRefused) {
    EXPECT_EQ(createTexelTracer(-1).status().code(), StatusCode::InvalidOption);
    EXPECT_EQ(createTexelTracer(1025).status().code(), StatusCode::InvalidOption);
    EXPECT_TRUE(createTexelTracer());
}

} // namespace
} // namespace aolib
