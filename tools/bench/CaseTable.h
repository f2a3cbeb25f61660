#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace aolib::bench {

/// What a scene is made of: bounds on errors differ by it.
enum class SceneKind {
    Generated, ///< closed solids, made by a generator
    Model,     ///< a file; open, non-manifold or both
    Foliage,   ///< a file of leaves
};

/// A scene that methods are judged on.
struct BenchScene {
    std::string name; ///< of a generated scene, or the stem of a model file
    SceneKind kind = SceneKind::Model;
    bool ground = false; ///< a large horizontal quad is added below it
};

/// One picture that methods are judged on: a scene, one of its cameras, and a radius.
struct BenchCase {
    BenchScene scene;
    std::size_t camera = 0;   ///< among those of camerasFor()
    double radiusShare = 0.1; ///< of the diagonal of the scene's bounding box, without the ground
};

/// Radii of the table, as shares of the scene's diagonal.
inline constexpr double kWideRadius = 0.10;
inline constexpr double kNarrowRadius = 0.02;

/// Every scene, in the order in which tables list them.
const std::vector<BenchScene>& benchScenes();

/// Every case: scenes x two cameras x two radii, cases of a scene in a row.
std::vector<BenchCase> benchCases();

} // namespace aolib::bench
