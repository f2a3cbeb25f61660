#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/CaseTable.h"
#include "content/LoadError.h"
#include "content/Model.h"
#include "content/NamedCamera.h"
#include "raytracing/RayScene.h"

namespace aolib::bench {

/// A scene of the bench in memory, ready to be drawn and to be traced.
struct OpenedScene {
    BenchScene entry;
    Model model; ///< with its ground, where it has one
    std::vector<NamedCamera> cameras;
    double diagonal = 0.0;         ///< of the bounding box without the ground, world units
    std::uint64_t fingerprint = 0; ///< of the triangles
    RayScene rays;
};

/// Opens a scene of the table. Errors: no such model among availableModels(), and whatever is wrong
/// with its file.
Result<OpenedScene, LoadError> openBenchScene(const BenchScene& entry);

} // namespace aolib::bench
