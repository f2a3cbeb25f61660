// A long walk through more rooms than the memory budget has room for, with stops at which the view
// rests until its pixels are computed, too: memory and objects stay flat.
// AOLIB_SOAK_FRAMES sets its length, and has the dearer estimators walk it too.
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include <unistd.h>

#include <aolib/RayTracing.h>

#include "GlObjects.h"
#include "Rooms.h"
#include "SmallScene.h"
#include "backbone/cubemaps/FaceStore.h"

namespace aolib {
namespace {

class SoakGLTest : public ContextTest, public testing::WithParamInterface<Estimator> {
protected:
    static constexpr int kRooms = 6;
    static constexpr int kFramesPerLap = 160; ///< to the last room and back
    static constexpr int kUsualFrames = 2 * kFramesPerLap;
    /// From one frame of a long walk in which GL is asked to the next: prime to those of a lap.
    static constexpr int kFramesBetween = 7;
    static constexpr int kFramesToStop = 40; ///< from one stop to the next
    static constexpr int kMostAtStop = 400;  ///< frames: a cube map alone takes 32 to come in
    static constexpr int kFaceSize = 128;    ///< the least that has detail
    static constexpr int kCubeMaps = 3;      ///< that the budget has room for

    void SetUp() override { open(testContexts().front()); }

    static int frames() {
        const char* wanted = std::getenv("AOLIB_SOAK_FRAMES");
        int count = 0;
        if (wanted != nullptr) {
            const std::string_view text(wanted);
            std::from_chars(text.data(), text.data() + text.size(), count);
        }
        return count;
    }

    static Options options() {
        Options o;
        o.estimator = GetParam();
        o.radius = 1.0F;
        o.frameBudget = 20.0F;
        o.horizonSplit = {.directions = 4, .steps = 4};
        o.layeredIntervals = {.slices = 2, .steps = 4, .layers = 2};
        o.rayTraced = {.rays = 16};
        o.cubeMaps.faceSize = kFaceSize;
        o.cubeMaps.memoryBudget = static_cast<float>(
            (kCubeMaps + 0.01) * kFaces * static_cast<double>(FaceStore::bytesPerLayer(kFaceSize)) /
            (1 << 20));
        return o;
    }

    /// Walks on, and looks about.
    static void step(SmallHost& host, int steps) {
        const float turn = 2.0F * static_cast<float>(steps % kFramesPerLap) / kFramesPerLap;
        const glm::vec3 eye = walkedTo((turn < 1.0F ? turn : 2.0F - turn) * (kRooms - 1));
        const float angle = 1.3F * std::sin(0.11F * static_cast<float>(steps));
        const float ahead = turn < 1.0F ? 1.0F : -1.0F;
        host.lookAt(eye, eye + glm::vec3(ahead * std::cos(angle), -0.1F, std::sin(angle)));
    }

    /// Memory of the process, bytes.
    static std::size_t resident() {
        std::ifstream file("/proc/self/statm");
        std::size_t pages = 0;
        file >> pages >> pages;
        return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    }

    struct Most {
        std::size_t kept = 0;    ///< bytes that cube maps keep
        std::size_t bytes = 0;   ///< of the context, less what is on its way
        std::size_t objects = 0; ///< of GL, while nothing is on its way
        std::size_t resident = 0;
        std::size_t atRest = 0; ///< pixels of a view at rest
    };

    /// Horizon split leaves pixels at rest to texels.
    static bool stops() { return GetParam() != Estimator::HorizonSplit; }
    /// Whether the view is to stay for another frame.
    static bool stays(int steps, int framesAtStop, const Statistics& s) {
        return stops() && steps % kFramesToStop == 0 && framesAtStop < kMostAtStop &&
               !(s.converged && framesAtStop > 0);
    }
    /// No cube map is on its way, nor pixels of a view at rest.
    static bool settled(const Statistics& s) {
        return s.bytesBuilding == 0 && (s.converged || !stops());
    }
};

TEST_P(SoakGLTest, MemoryAndObjectsStayFlat) {
    const int asked = frames();
    if (asked == 0 && GetParam() != Estimator::HorizonSplit) {
        GTEST_SKIP() << "a long walk: set AOLIB_SOAK_FRAMES";
    }
    const int count = std::max(asked, kUsualFrames);
    SmallHost host(gl, loader, rooms(kRooms), options(), 160, 90);
    if (GetParam() == Estimator::RayTraced) { // else it would trace pixels at rest for the others
        host.ao().setTexelTracer(std::move(*createTexelTracer(1)));
    }
    const GlObjects objects(gl, loader);
    const std::size_t budget =
        static_cast<std::size_t>(kCubeMaps * kFaces) * FaceStore::bytesPerLayer(kFaceSize);
    const int every = count > 10 * kUsualFrames ? kFramesBetween : 1;
    std::array<Most, 2> most; // of the first half, of the second
    int atStop = 0;
    int frame = 0;
    for (int steps = 0; steps < count; ++frame) {
        step(host, steps);
        ASSERT_TRUE(host.frame().ok()) << host.ao().lastStatus().message();
        const Statistics s = host.ao().statistics();
        ASSERT_LE(s.bytesKept, budget) << "frame " << frame;
        Most& half = most.at(steps < count / 2 ? 0 : 1);
        if (stays(steps, atStop, s)) {
            ++atStop;
        } else {
            atStop = 0;
            ++steps;
        }
        half.atRest = std::max(half.atRest, s.pixelsRefined);
        half.kept = std::max(half.kept, s.bytesKept);
        if (frame % every != 0 && !(stops() && settled(s))) {
            continue;
        }
        half.bytes = std::max(half.bytes, objects.bytes() - s.bytesBuilding);
        if (settled(s)) {
            half.objects = std::max(half.objects, objects.count());
        }
        half.resident = std::max(half.resident, resident());
        (void)takeDriverMessages(); // about textures asked for as those of another kind
    }
    const Statistics s = host.ao().statistics();
    EXPECT_GE(s.cubeMapsEvicted, static_cast<std::uint64_t>(count / (2 * kFramesPerLap)))
        << "the walk must need more than there is room for";
    EXPECT_LE(most[1].bytes, most[0].bytes);
    EXPECT_LE(most[1].kept, most[0].kept);
    constexpr std::size_t kOnItsWay = 8; // fences, targets of a capture: the walk is not the same
    EXPECT_GT(most[0].objects, 0U);
    EXPECT_LE(most[1].objects, most[0].objects + (stops() ? 0 : kOnItsWay));
    constexpr std::size_t kFragments = std::size_t{4} << 20;
    EXPECT_LE(most[1].resident, most[0].resident + kFragments);
    for (const char* name : {"first", "second"}) {
        const Most& half = most.at(std::string_view(name) == "first" ? 0 : 1);
        const std::string which = std::string(name) + " half, ";
        RecordProperty(which + "bytes kept", std::to_string(half.kept));
        RecordProperty(which + "bytes in GL", std::to_string(half.bytes));
        RecordProperty(which + "objects in GL", std::to_string(half.objects));
        RecordProperty(which + "resident bytes", std::to_string(half.resident));
        RecordProperty(which + "pixels at rest", std::to_string(half.atRest));
        EXPECT_EQ(half.atRest > 0, GetParam() != Estimator::HorizonSplit) << which << "at rest";
    }
    RecordProperty("frames", std::to_string(frame));
    RecordProperty("evicted", std::to_string(s.cubeMapsEvicted));
}

std::string nameOfEstimator(const testing::TestParamInfo<Estimator>& info) {
    constexpr std::array kNames{"HorizonSplit", "LayeredIntervals", "RayTraced"};
    return kNames.at(static_cast<std::size_t>(info.param));
}

INSTANTIATE_TEST_SUITE_P(Estimators, SoakGLTest,
                         testing::Values(Estimator::HorizonSplit, Estimator::LayeredIntervals,
                                         Estimator::RayTraced),
                         nameOfEstimator);

} // namespace
} // namespace aolib
