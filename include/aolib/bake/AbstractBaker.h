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

/// Told the share that is done, 0 to 1; returning false cancels: nothing is given. Called from the
/// calling thread.
using BakeProgress = std::function<bool(double fraction)>;

/// What a texel of a map stands on.
enum class TexelKind : std::uint8_t {
    Empty,  ///< nothing; its value, if any, comes from the nearest charts
    Border, ///< a chart covers part of it, not its centre
    Inside, ///< its centre lies in a chart
};

/// A baked map. Row 0 is the bottom row, v = 0; index `y * width + x`. Since 0.1.
struct BakedMap {
    int width = 0;                     ///< texels
    int height = 0;                    ///< texels
    std::vector<float> visibility;     ///< 0 closed to 1 open; -1 where there is no value
    std::vector<glm::vec3> bentNormal; ///< mean open direction, world space, unit length; the
                                       ///< surface's normal where nothing is open; 0 without value
    std::vector<TexelKind> kind;       ///< before padding
};

/// Values of one surface's vertices, as many as it has positions. Since 0.1.
struct BakedVertices {
    std::vector<float> visibility;     ///< 0 to 1; 1 where no triangle with an area uses it
    std::vector<glm::vec3> bentNormal; ///< as in BakedMap
    std::vector<OpenSectors> sectors;  ///< the open rays of those that a vertex sent to each, W
                                       ///< where it sent none; where asked for, else none
};

/// Computes visibility W and bent normals of a scene, by whatever method. Directions below a
/// triangle's own plane count as closed, whatever its shading normal says; occluders are
/// two-sided; each surface is lit on the side of its normals. Since 0.1.
///
/// Threads: one call at a time. Bakers on the GPU need the context that they were created in, or
/// one that shares its objects; elsewhere a call answers WrongContext or NoContext and changes
/// nothing.
class AOLIB_BAKE_EXPORT AbstractBaker {
public:
    AbstractBaker() = default;
    AbstractBaker(const AbstractBaker&) = delete;
    AbstractBaker& operator=(const AbstractBaker&) = delete;
    virtual ~AbstractBaker();

    /// All maps of the scene, by number; the map of a number that no surface has is empty.
    /// Errors: InvalidOption, OutOfMemory, Cancelled, InvalidPosition where no triangle of the
    /// scene has usable UVs.
    /// @param onSnapshot  is shown the maps while they come about, and may end the bake early.
    virtual Result<std::vector<BakedMap>> bakeMaps(const MapOptions& options,
                                                   const BakeProgress& progress,
                                                   const SnapshotCallback& onSnapshot) = 0;
    Result<std::vector<BakedMap>> bakeMaps(const MapOptions& options,
                                           const BakeProgress& progress) {
        return bakeMaps(options, progress, {});
    }

    /// The vertices of all surfaces, in their order. Surfaces that only occlude get none.
    /// Errors: InvalidOption, MissingCapability (the method does not have this fit), OutOfMemory,
    /// Cancelled.
    virtual Result<std::vector<BakedVertices>> bakeVertices(const VertexOptions& options,
                                                            const BakeProgress& progress) = 0;

    /// What a view shows, in its own pixels: W -1 and no bent normal where that is nothing. Places
    /// are lit on the side of their normals, whichever side of the scene's surfaces that is.
    /// Errors: InvalidOption (sizes, lift), InvalidPosition, InvalidNormal, MissingCapability
    /// (scattering), OutOfMemory, Cancelled.
    virtual Result<BakedMap> bakeView(const ViewPixels& view, const BakeProgress& progress) = 0;
};

/// A baker that traces rays on all cores with Embree.
/// Errors: those of the scene (InvalidPosition, InvalidIndex, InvalidNormal, IncompletePrimitive,
/// EmptyMesh, naming the surface), InvalidOption, MissingCapability, OutOfMemory. Since 0.1.
AOLIB_BAKE_EXPORT Result<std::unique_ptr<AbstractBaker>> createRayBaker(BakeScene scene,
                                                                        const RayOptions& options);

/// A baker of maps and vertices on the GPU: from each of many directions the model is drawn, and
/// what is seen is scattered as points into its map (McGraw and Sowers 2008), or among the corners
/// of its triangles: `VertexFit::Direct` is then the mean about each vertex, nearer places counting
/// more, and TriangleMean answers MissingCapability. Any OpenGL 3.3 context will do: that
/// which is current, or one that shares its objects, must be so in all later calls, and after each
/// call of a callback the one that was before. Destroyed in another context, or in none, a baker
/// touches no object. GL state is saved and restored by each call, and around each call of the
/// progress callback.
/// Errors: those of the scene as above, InvalidOption, NoContext, MissingCapability, ShaderError,
/// OutOfMemory. Since 0.1.
AOLIB_BAKE_EXPORT Result<std::unique_ptr<AbstractBaker>>
createScatterBaker(const ProcAddressLoader& loader, BakeScene scene, const ScatterOptions& options);

/// A baker of maps and vertices on the GPU: a depth map per direction, then every receiver asks
/// which of them see it (GPU Gems, chapter 17.3). Context and errors as for createScatterBaker().
/// Since 0.1.
AOLIB_BAKE_EXPORT Result<std::unique_ptr<AbstractBaker>>
createShadowBaker(const ProcAddressLoader& loader, BakeScene scene, const ShadowOptions& options);

} // namespace aolib::bake
