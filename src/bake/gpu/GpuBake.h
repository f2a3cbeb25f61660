#pragma once

#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <utility>

#include <aolib/ProcAddressLoader.h>
#include <aolib/bake/AbstractBaker.h>

#include "bake/geometry/BakeGeometry.h"
#include "bake/gpu/BakeVertices.h"
#include "bake/gpu/LightView.h"
#include "bake/gpu/Reach.h"
#include "bake/maps/CheckOptions.h"
#include "gl/ContextGroup.h"

namespace aolib::bake {

/// The directions of light of a bake, and the pictures taken along them.
struct DirectionPlan {
    int first = 0;                    ///< direction
    int last = 0;                     ///< direction, not among them
    int atOnce = 1;                   ///< pictures between two calls of the progress callback
    int pictureSize = 0;              ///< pixels along a picture's side
    std::optional<FrameBox> box = {}; ///< what pictures show; none: the scene
    Sky sky = Sky::Sphere;
    std::uint32_t seed = 0;
};

/// Adds what up to `atOnce` directions light, with known GL state.
using AddViews = std::function<AoStatus(std::span<const LightView> views)>;

/// What every baker on the GPU has, and does.
struct GpuBake {
    std::unique_ptr<gl::Functions> gl; ///< in one place: GL objects refer to it
    std::unique_ptr<gl::ContextGroup> contexts;
    BakeGeometry geometry;
    BakeFrame frame;
    Reach reach = {}; ///< of occluders

    /// Errors: those of BakeGeometry::create() and gl::Functions::load().
    static Result<GpuBake> create(const ProcAddressLoader& loader, BakeScene scene);

    /// Up and the ground's height along it, in the frame; 0 where there is no ground.
    glm::vec4 ground() const;
    /// The triangles, for maps of this size, with the numbers of their facets or without. Errors:
    /// OutOfMemory.
    Result<BakeVertices> upload(int width, int height, const Facets* facets) const;
    /// Goes through the directions, giving the host its GL state and the word in between.
    /// @param goOn  receives the number of directions so far; returning false ends the bake.
    /// @return how many there are. Errors: Cancelled, WrongContext and NoContext (of a callback
    /// that left it so), and those of `add`.
    Result<int> addDirections(const DirectionPlan& plan, const BakeProgress& progress,
                              const AddViews& add,
                              const std::function<bool(int done)>& goOn = {}) const;
};

/// Visibility per unit of summed cosines of all directions of a sky: a point that no direction is
/// closed to gets 1, but for what the directions miss of the integral.
double cosineNorm(Sky sky, int directions);

/// Makes a baker of a GpuBake and its options. Errors: as createScatterBaker() says.
template <typename Baker, typename Options>
Result<std::unique_ptr<AbstractBaker>> createGpuBaker(const ProcAddressLoader& loader,
                                                      BakeScene scene, const Options& options) try {
    if (AoStatus status = check(options); !status) {
        return status;
    }
    Result<GpuBake> gpu = GpuBake::create(loader, std::move(scene));
    if (!gpu) {
        return gpu.status();
    }
    gpu->reach = {double{options.radius} * gpu->frame.scale(), options.falloff};
    if (AoStatus status = checkReach(gpu->reach, gpu->frame.scale()); !status) {
        return status;
    }
    return std::unique_ptr<AbstractBaker>(std::make_unique<Baker>(std::move(*gpu), options));
} catch (const std::bad_alloc&) {
    return AoStatus(StatusCode::OutOfMemory, "no memory left for the scene to bake");
}

} // namespace aolib::bake
