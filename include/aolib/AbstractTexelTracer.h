#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <aolib/Export.h>
#include <aolib/Options.h>
#include <aolib/Status.h>

namespace aolib {

/// A primary ray from one end to the other; it sees the first surface between the ends. World
/// units, relative to the request's centre.
struct LineOfSight {
    glm::vec3 from{0.0F};
    glm::vec3 to{0.0F}; ///< must differ from `from`
};

/// Requests rays for a rectangle of texels on one face of a cube map. Lengths in world units.
/// For coherent packets use tiles that are multiples of 4 x 4 texels, and 64 or 256 rays with
/// `firstRay` a multiple of the count.
struct TexelRequest {
    std::uint64_t key = 0;           ///< chosen by the caller; copied to the result
    glm::vec3 centre{0.0F};          ///< of the cube map
    int faceSize = 0;                ///< texels along a face's edge, 1 to 65536
    int face = 0;                    ///< +X -X +Y -Y +Z -Z as in shaders/shared/cube_faces.h
    int x = 0;                       ///< leftmost column of texels
    int y = 0;                       ///< lowest row of texels
    int width = 0;                   ///< texels, at least 1
    int height = 0;                  ///< texels, at least 1; `width * height` at most 2^24
    int firstRay = 0;                ///< index into each texel's ray sequence, 0 or more
    int rays = 0;                    ///< rays per texel to trace now, at least 1
    float radius = 0.0F;             ///< above 0; `Falloff::Off` ignores it
    Falloff falloff = Falloff::Step; ///< weight of a hit by its distance
    /// Empty, or `width * height` primary rays that replace those through the face's texels.
    /// `face`, `x` and `y` then only select the ray sequences, and may lie outside the face.
    std::vector<LineOfSight> primaryRays;
};

/// The result of a request: arrays of `width * height`, row 0 at the bottom.
struct TracedTexels {
    TexelRequest request;
    std::uint64_t scene = 0; ///< number of the traced scene, as `setScene()` returned it
    std::vector<float>
        visibility;              ///< mean W over exactly the request's rays; 1 where nothing is hit
    std::vector<float> distance; ///< to the first surface along the primary ray, world units; -1
                                 ///< if the ray hits nothing
    std::vector<glm::vec3> normal; ///< of the hit triangle, turned to the centre; 0 if the primary
                                   ///< ray hits nothing
};

/// Traces texels of cube maps in the background; `createTexelTracer()` makes an implementation.
///
/// The surface of a texel is the first hit of its primary ray, from the cube map's centre through
/// the texel's centre. Rays leave that surface in the hemisphere about the shading normal, with a
/// cosine-weighted density. Rays below the plane of the hit triangle count as blocked.
/// The shading normal is interpolated from the scene's normals and turned to the centre. Where
/// these are missing or cancel out, the geometric normal is used.
///
/// Each texel has one endless sequence of rays, which depends only on its face, column and row.
/// Requests with consecutive `firstRay` continue the sequence; the mean of their results, weighted
/// by `rays`, is the mean of all rays. Neither threads nor the order of requests change a result.
///
/// Threads: all methods may be called from any thread; only `wait()` blocks. Since 0.1.
class AOLIB_EXPORT AbstractTexelTracer {
public:
    AbstractTexelTracer() = default;
    AbstractTexelTracer(const AbstractTexelTracer&) = delete;
    AbstractTexelTracer& operator=(const AbstractTexelTracer&) = delete;
    /// Stops the workers; unfinished requests are discarded.
    virtual ~AbstractTexelTracer();

    /// Replaces the scene. Returns at once: a worker builds the acceleration structure, and until
    /// then requests are traced in the previous scene, if there is one.
    /// Requests and results stay; each result has the number of its scene.
    /// If scenes come faster than they are built, older ones are skipped, never the latest.
    /// Resets `status()` to Ok.
    /// @param positions  world space.
    /// @param indices    three per triangle; empty for a scene in which no ray hits anything.
    /// @param normals    empty, or one per position: of length 1, or zero for a vertex without.
    /// @return the scene's number, at least 1, greater than that of every earlier scene.
    virtual std::uint64_t setScene(std::vector<glm::vec3> positions,
                                   std::vector<std::uint32_t> indices,
                                   std::vector<glm::vec3> normals = {}) = 0;

    /// Replaces the queue of requests; the first is traced first. Returns at once.
    /// Requests that a worker has begun are finished, and their results delivered.
    /// Requests out of range are dropped. Without a scene, or with a rejected one, all requests are
    /// dropped. `status()` then holds the error.
    virtual void request(std::vector<TexelRequest> queue) = 0;

    /// Removes and returns at most `most` finished requests, in the order in which they finished.
    virtual std::vector<TracedTexels> take(std::size_t most) = 0;

    /// Waits until take() has a result, or no request is queued or begun. Returns false at the
    /// time limit, in milliseconds.
    virtual bool wait(double milliseconds) = 0;

    /// Counts the requests that are queued, begun, or finished and not yet taken.
    virtual std::size_t pending() const = 0;

    /// Returns the first failure since `setScene()`, or Ok.
    /// For a rejected scene: IncompletePrimitive, InvalidIndex, InvalidPosition, InvalidNormal (not
    /// finite, or not one per position).
    /// For a dropped request: InvalidPosition (its centre), InvalidOption (out of range), NoScene.
    /// For either: OutOfMemory.
    virtual AoStatus status() const = 0;
};

} // namespace aolib
