#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <aolib/bake/BakeOptions.h>

#include "bench/bake/BakeRun.h"

namespace aolib::bench {

/// A way to bake vertices.
struct VertexMethod {
    BakeMethodName method = BakeMethodName::Rays;
    bake::VertexFit fit = bake::VertexFit::Direct;
};
const char* vertexFitName(bake::VertexFit fit);

/// A line of the table of vertices.
struct VertexRow {
    std::string mesh;
    std::size_t vertices = 0; ///< that triangles use
    VertexMethod how;
    int samples = 0;         ///< rays, or directions
    double processor = 0.0;  ///< seconds of all cores together
    double atVertices = 0.0; ///< RMSE of W over the vertices
    double onSurface = 0.0;  ///< RMSE of W over the surface, interpolated along it
};

/// A mesh whose triangles are each cut into four, and whose vertices are those of the mesh and then
/// the middles of its edges.
struct CutMesh {
    bake::BakeScene scene;
    /// Per surface and middle: the vertices at its edge's ends.
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> ends;
};
CutMesh cutInFour(const bake::BakeScene& scene);

/// How far values of a mesh's vertices are from the truth at its cut mesh's. Over the surface the
/// mean is taken at the middles of the edges, each for a third of the triangles about it, which is
/// exact for what is quadratic on triangles.
void compareVertices(const bake::BakeScene& scene, const CutMesh& cut,
                     const std::vector<bake::BakedVertices>& values,
                     const std::vector<bake::BakedVertices>& truth, VertexRow& row);

/// Bakes the plan's meshes' vertices with each of its numbers of samples in all ways that there
/// are; its methods and its maps are ignored. @param tell  as for runBakePlan().
Result<std::vector<VertexRow>>
runVertexPlan(const BakePlan& plan, const ProcAddressLoader& loader,
              const std::function<bool(const std::string& next, double done)>& tell);

/// The rows as text.
std::string vertexCsv(const std::vector<VertexRow>& rows);
std::string vertexMarkdown(const std::vector<VertexRow>& rows);

} // namespace aolib::bench
