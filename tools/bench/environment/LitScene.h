#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <aolib/Status.h>
#include <aolib/bake/AbstractBaker.h>

#include "content/Model.h"
#include "host/LitMesh.h"
#include "scene/TriangleMesh.h"

namespace aolib::bench {

/// How a model is made ready for environment lighting.
struct LitSceneOptions {
    double edge = 0.005; ///< longest edge, of the model's diagonal
    std::size_t mostTriangles = 1000000;
    bool ground = false; ///< put a disc below the model
    int rays = 256;      ///< per vertex
};

/// A model in world space with normals, fine enough for values of vertices, and those values.
struct LitScene {
    std::string name;
    std::vector<host::LitPiece> pieces;
    double bakeSeconds = 0.0;

    /// All pieces as one.
    TriangleMesh mesh() const;
    std::size_t vertices() const;
};

/// Tessellates a model, gives it normals where it has none, and bakes its vertices by rays twice:
/// by the cosine, and plain. Errors: those of createRayBaker() and bakeVertices().
Result<LitScene> bakeLitScene(Model model, const LitSceneOptions& options,
                              const bake::BakeProgress& progress = {});

} // namespace aolib::bench
