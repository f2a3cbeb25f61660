#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include <aolib/BakeExport.h>
#include <aolib/OpenSectors.h>
#include <aolib/ProcAddressLoader.h>
#include <aolib/Status.h>
#include <aolib/bake/BakeOptions.h>
#include <aolib/bake/BakeScene.h>
#include <aolib/bake/BakeSnapshot.h>
#include <aolib/bake/ViewPixels.h>

namespace aolib::bake {

/// Receives the share of the bake that is done, 0 to 1; returning false cancels the bake, which
/// then returns no values. Called in the calling thread.
using BakeProgress = std::function<bool(double fraction)>;

/// How much of a texel charts cover.
enum class TexelKind : std::uint8_t {
    Empty,  ///< no chart covers it; its value, if any, comes from the nearest charts
    Border, ///< a chart covers part of it, but not its centre
    Inside, ///< a chart covers its centre
};

/// A baked map. Row 0 is the bottom row, v = 0; index `y * width + x`. Since 0.1.
struct BakedMap {
    int width = 0;                     ///< texels
    int height = 0;                    ///< texels
    std::vector<float> visibility;     ///< W, 0 (blocked) to 1 (open); -1 where there is no value
    std::vector<glm::vec3> bentNormal; ///< mean open direction, world space, unit length; the
                                       ///< surface's normal if no direction is open; 0 if no value
    std::vector<TexelKind> kind;       ///< before padding
};

/// Values of one surface's vertices, as many as it has positions. Since 0.1.
struct BakedVertices {
    std::vector<float> visibility;     ///< 0 to 1; 1 where no triangle with an area uses it
    std::vector<glm::vec3> bentNormal; ///< as in BakedMap
    std::vector<OpenSectors> sectors;  ///< share of open rays by sector, W in sectors without
                                       ///< rays; empty unless `RayOptions::sectors`
};

/// Computes visibility W and bent normals of a scene. All methods follow the same rules:
/// - Directions below a triangle's plane are blocked, whatever its shading normal is.
/// - Occluders are two-sided.
/// - Each surface is lit on the side of its normals.
/// Since 0.1.
///
/// Threads: one call at a time. Bakers on the GPU need the context that they were created in, or
/// one that shares its objects; in another, or in none, a call returns WrongContext or NoContext
/// and changes nothing.
class AOLIB_BAKE_EXPORT AbstractBaker {
public:
    AbstractBaker() = default;
    AbstractBaker(const AbstractBaker&) = delete;
    AbstractBaker& operator=(const AbstractBaker&) = delete;
    virtual ~AbstractBaker();

    /// Bakes all maps of the scene, by number. The map of a number that no surface has is empty.
    /// Errors: InvalidOption, OutOfMemory, Cancelled, InvalidPosition if no triangle of the scene
    /// has usable UVs.
    /// @param onSnapshot  may read the maps during the bake, and may end it early; may be empty.
    virtual Result<std::vector<BakedMap>> bakeMaps(const MapOptions& options,
                                                   const BakeProgress& progress,
                                                   const SnapshotCallback& onSnapshot) = 0;
    Result<std::vector<BakedMap>> bakeMaps(const MapOptions& options,
                                           const BakeProgress& progress) {
        return bakeMaps(options, progress, {});
    }

    /// Bakes the vertices of all surfaces, in their order. Surfaces that only occlude get no
    /// values. Errors: InvalidOption, MissingCapability (the method does not support this fit),
    /// OutOfMemory, Cancelled.
    virtual Result<std::vector<BakedVertices>> bakeVertices(const VertexOptions& options,
                                                            const BakeProgress& progress) = 0;

    /// Bakes the pixels of a view. Pixels that show nothing get W = -1 and no bent normal. Each
    /// pixel is lit on the side of its normal, whichever side of the scene's surface that is.
    /// Errors: InvalidOption (sizes, lift), InvalidPosition, InvalidNormal, MissingCapability
    /// (scattering), OutOfMemory, Cancelled.
    virtual Result<BakedMap> bakeView(const ViewPixels& view, const BakeProgress& progress) = 0;
};

/// Creates a baker that traces rays on all cores with Embree.
/// Errors: those of the scene (InvalidPosition, InvalidIndex, InvalidNormal, IncompletePrimitive,
/// EmptyMesh, naming the surface), InvalidOption, MissingCapability, OutOfMemory. Since 0.1.
AOLIB_BAKE_EXPORT Result<std::unique_ptr<AbstractBaker>> createRayBaker(BakeScene scene,
                                                                        const RayOptions& options);

/// Creates a baker of maps and vertices on the GPU. It draws the model from many directions, and
/// scatters the visible pixels as points into the map (McGraw and Sowers 2008), or among the
/// corners of their triangles.
/// - Vertices: `VertexFit::Direct` is the mean about each vertex, in which nearer pixels weigh
/// more.
///   `VertexFit::TriangleMean` returns MissingCapability.
/// - Context: any of OpenGL 3.3. In later calls the current context must be the one of this call,
/// or
///   one that shares its objects. A callback must leave the context current that it was called in.
/// - A baker that is destroyed in another context, or in none, deletes no GL object.
/// - GL state is saved and restored by each call, and around each call of a callback.
/// Errors: those of the scene as above, InvalidOption, NoContext, MissingCapability, ShaderError,
/// OutOfMemory. Since 0.1.
AOLIB_BAKE_EXPORT Result<std::unique_ptr<AbstractBaker>>
createScatterBaker(const ProcAddressLoader& loader, BakeScene scene, const ScatterOptions& options);

/// Creates a baker of maps and vertices on the GPU by shadow maps: it draws a depth map per
/// direction, and compares every receiver with all of them (GPU Gems, chapter 17.3). Context and
/// errors as for createScatterBaker(). Since 0.1.
AOLIB_BAKE_EXPORT Result<std::unique_ptr<AbstractBaker>>
createShadowBaker(const ProcAddressLoader& loader, BakeScene scene, const ShadowOptions& options);

} // namespace aolib::bake
