#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <aolib/Export.h>
#include <aolib/Options.h>
#include <aolib/Status.h>

namespace aolib {

/// Where someone looks: the first surface between the ends is seen. World units, relative to the
/// request's centre.
struct LineOfSight {
    glm::vec3 from{0.0F};
    glm::vec3 to{0.0F}; ///< elsewhere than `from`
};

/// A rectangle of texels of one cube map's face that is to be traced. Lengths in world units.
/// Cheapest are multiples of 4 by 4 texels, and 64 or 256 rays that start at a multiple of
/// their number: rays of alike texels that point alike are traced together.
struct TexelRequest {
    std::uint64_t key = 0;           ///< the caller's own; comes back with the result
    glm::vec3 centre{0.0F};          ///< of the cube map
    int faceSize = 0;                ///< texels along a face's edge, 1 to 65536
    int face = 0;                    ///< +X -X +Y -Y +Z -Z as in shaders/shared/cube_faces.h
    int x = 0;                       ///< leftmost column of texels
    int y = 0;                       ///< lowest row of texels
    int width = 0;                   ///< texels, at least 1
    int height = 0;                  ///< texels, at least 1; `width * height` at most 2^24
    int firstRay = 0;                ///< rays of each texel's sequence that were traced before
    int rays = 0;                    ///< rays per texel to trace now, at least 1
    float radius = 0.0F;             ///< above 0; `Falloff::Off` ignores it
    Falloff falloff = Falloff::Step; ///< weight of a hit by its distance
    /// Not empty: what is traced in place of a face's texels, `width * height` of them. Face and
    /// place then only choose their sequences of rays, and need not lie within a face.
    std::vector<LineOfSight> primaryRays;
};

/// The answer to a request: arrays of `width * height`, row 0 at the bottom.
struct TracedTexels {
    TexelRequest request;
    std::uint64_t scene = 0; ///< the number of the scene that was traced, as `setScene()` gave it
    std::vector<float>
        visibility;              ///< mean W over exactly the request's rays; 1 where nothing is hit
    std::vector<float> distance; ///< of the surface that the texel's centre sees, along its ray;
                                 ///< -1 where it sees nothing
    std::vector<glm::vec3> normal; ///< of the triangle, turned to the centre; 0 where it
                                   ///< sees nothing
};

/// Traces texels of cube maps in the background. `aolib/RayTracing.h` makes one.
///
/// A texel sees the surface that the ray from the cube map's centre through the texel's centre
/// meets first. Rays leave it over the hemisphere about its shading normal, with the density of the
/// cosine; those that go below the plane of its triangle are blocked at once. The shading normal is
/// the scene's, interpolated and turned to the centre, or the geometric one where the scene has
/// none or where they cancel out. Each texel has one endless sequence of rays, which depends on its
/// face, column and row alone: requests with consecutive `firstRay` continue it, their means
/// weighed by `rays` are the mean of the whole, and neither threads nor the order of requests
/// change a result.
///
/// Threads: all methods may be called from any thread, and only `wait()` waits. Since 0.1.
class AOLIB_EXPORT AbstractTexelTracer {
public:
    AbstractTexelTracer() = default;
    AbstractTexelTracer(const AbstractTexelTracer&) = delete;
    AbstractTexelTracer& operator=(const AbstractTexelTracer&) = delete;
    /// Stops the workers, whatever they are at.
    virtual ~AbstractTexelTracer();

    /// Exchanges the scene: indexed triangles in world space. `normals` is empty, or has one per
    /// position: of length 1, or zero for a vertex that has none. Returns at once: a worker builds
    /// the acceleration structure, and until it is there requests are traced in the scene before,
    /// if there is one. Requests and results stay; each result names its scene. Of scenes that come
    /// faster than they can be built, some are left out, never the latest. Forgets the failure that
    /// `status()` told. A scene without triangles is allowed: nothing is ever hit.
    /// @return a number for the scene, above that of every scene before it, at least 1.
    virtual std::uint64_t setScene(std::vector<glm::vec3> positions,
                                   std::vector<std::uint32_t> indices,
                                   std::vector<glm::vec3> normals = {}) = 0;

    /// Replaces the queue, first served first. What a worker has begun goes on; its result still
    /// comes. Requests out of range are left out, and all of them where there is no scene or it was
    /// rejected; `status()` says so. Returns at once.
    virtual void request(std::vector<TexelRequest> queue) = 0;

    /// Finished requests since the last call, at most `most`, in the order in which they were
    /// finished.
    virtual std::vector<TracedTexels> take(std::size_t most) = 0;

    /// Waits until something can be taken or nothing is queued or begun; false at the time limit.
    virtual bool wait(double milliseconds) = 0;

    /// Requests queued, begun, or finished and not yet taken.
    virtual std::size_t pending() const = 0;

    /// The first failure since `setScene()`. The scene is rejected: IncompletePrimitive,
    /// InvalidIndex, InvalidPosition, InvalidNormal (not finite, or not as many as positions). A
    /// request is left out: InvalidPosition (its centre), InvalidOption (out of range), NoScene.
    /// Either: OutOfMemory.
    virtual AoStatus status() const = 0;
};

} // namespace aolib
