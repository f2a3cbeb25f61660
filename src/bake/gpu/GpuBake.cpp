#include "bake/gpu/GpuBake.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "bake/maps/ProgressiveBake.h"
#include "gl/StateGuard.h"

namespace aolib::bake {

Result<GpuBake> GpuBake::create(const ProcAddressLoader& loader, BakeScene scene) {
    Result<BakeGeometry> geometry = BakeGeometry::create(std::move(scene));
    if (!geometry) {
        return geometry.status();
    }
    Result<gl::Functions> functions = gl::Functions::load(loader);
    if (!functions) {
        return functions.status();
    }
    auto gl = std::make_unique<gl::Functions>(*functions);
    auto contexts = std::make_unique<gl::ContextGroup>(*gl);
    gl->group = contexts.get();
    if (AoStatus status = contexts->found(); !status) {
        return status;
    }
    const BakeFrame frame(geometry->bounds());
    return GpuBake{std::move(gl), std::move(contexts), std::move(*geometry), frame, {}};
}

glm::vec4 GpuBake::ground() const {
    if (!geometry.scene().ground) {
        return glm::vec4(0.0F);
    }
    const glm::dvec3 point = double{*geometry.scene().ground} * geometry.up();
    const double height = glm::dot(glm::dvec3(frame.toFrame(point)), geometry.up());
    return {glm::vec3(geometry.up()), static_cast<float>(height)};
}

Result<BakeVertices> GpuBake::upload(int width, int height, const Facets* facets) const {
    const gl::StateGuard guard(*gl);
    return BakeVertices::create(*gl, geometry, frame, width, height, facets, !reach.endless());
}

Result<int> GpuBake::addDirections(const DirectionPlan& plan, const BakeProgress& progress,
                                   const AddViews& add,
                                   const std::function<bool(int done)>& goOn) const {
    const FrameBox box = plan.box.value_or(FrameBox{glm::dvec3(0.0), frame.halfExtent()});
    std::vector<LightView> views;
    for (int first = plan.first; first < plan.last; first += plan.atOnce) {
        if (progress && !progress(double(first - plan.first) / double(plan.last - plan.first))) {
            return cancelledBake();
        }
        if (AoStatus status = contexts->confirm(); !status) {
            return status;
        }
        views.clear();
        const int next = std::min(first + plan.atOnce, plan.last);
        for (int i = first; i < next; ++i) {
            const auto index = static_cast<std::uint32_t>(i);
            const glm::dvec3 direction = lightDirection(plan.sky, geometry.up(), plan.seed, index);
            views.push_back(lightView(frame, box, direction, plan.pictureSize, plan.seed, index));
            views.back().reach = drawRadius(reach, plan.seed, index);
        }
        {
            const gl::StateGuard guard(*gl);
            if (AoStatus status = add(views); !status) {
                return status;
            }
            gl->Finish();
        }
        const bool enough = goOn && !goOn(next - plan.first);
        if (AoStatus status = contexts->confirm(); !status) {
            return status;
        }
        if (enough) {
            return next - plan.first;
        }
    }
    return plan.last - plan.first;
}

double cosineNorm(Sky sky, int directions) {
    // The sum is an average over a sphere's 4 pi, or a dome's 2 pi, times their number; a
    // hemisphere's cosines have the integral pi.
    return (sky == Sky::Sphere ? 4.0 : 2.0) / double(directions);
}

} // namespace aolib::bake
