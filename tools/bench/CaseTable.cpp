#include "bench/CaseTable.h"

namespace aolib::bench {

namespace {

constexpr std::size_t kCameras = 2;

} // namespace

const std::vector<BenchScene>& benchScenes() {
    static const std::vector<BenchScene> scenes{
        {"town", SceneKind::Generated, false},     {"room", SceneKind::Generated, false},
        {"dome", SceneKind::Generated, false},     {"bunny", SceneKind::Model, true},
        {"cloister", SceneKind::Model, false},     {"delft", SceneKind::Model, false},
        {"zdm2", SceneKind::Model, false},         {"franka_panda", SceneKind::Model, false},
        {"sponza_ivy", SceneKind::Foliage, false},
    };
    return scenes;
}

std::vector<BenchCase> benchCases() {
    std::vector<BenchCase> cases;
    for (const BenchScene& scene : benchScenes()) {
        for (std::size_t camera = 0; camera < kCameras; ++camera) {
            for (const double radius : {kWideRadius, kNarrowRadius}) {
                cases.push_back({scene, camera, radius});
            }
        }
    }
    return cases;
}

} // namespace aolib::bench
