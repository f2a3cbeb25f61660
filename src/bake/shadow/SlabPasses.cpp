#include "bake/shadow/SlabPasses.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "bake/gpu/BakeShaders.h"
#include "gl/Label.h"

namespace aolib::bake {

namespace {

struct SlabRange {
    int first = 0;
    int last = 0; ///< not among them
};

/// The slabs that a box lies in, and what is lifted off it by a length.
SlabRange findSlabs(const Slabs& slabs, const FrameBox& box, double lift) {
    const glm::dvec3 axis(slabs.axis());
    const auto middle = double{slabs.coordinate(glm::vec3(box.centre))};
    const double half = glm::dot(glm::abs(axis), box.half) + glm::length(axis) * lift + 1e-3;
    return {std::clamp(static_cast<int>(std::floor(middle - half)), 0, slabs.count() - 1),
            std::clamp(static_cast<int>(std::floor(middle + half)), 0, slabs.count() - 1) + 1};
}

double computeTexelSide(const LightView& view) {
    return std::max(view.pixel.x, view.pixel.y);
}

} // namespace

Result<SlabPasses> SlabPasses::create(const gl::Functions& gl, const DepthSettings& settings,
                                      const BakeVertices& vertices) {
    Result<DepthTiles> tiles = DepthTiles::create(gl, settings.size, 2 * settings.mapsPerPass);
    if (!tiles) {
        return tiles.status();
    }
    if (tiles->count() < 2) {
        return AoStatus(StatusCode::MissingCapability,
                        "no texture of this context holds two depth maps of " +
                            std::to_string(settings.size) + " texels a side");
    }
    Result<gl::GLSLShader> gather =
        buildBakeShader(gl, "bake/fullscreen.vert", "bake/slab_gather.frag");
    if (!gather) {
        return gather.status();
    }
    SlabPasses passes(gl, settings, vertices);
    passes.pairs_ = tiles->count() / 2;
    passes.tiles_ = std::move(*tiles);
    passes.gatherShader_ = std::move(*gather);
    return passes;
}

AoStatus SlabPasses::addDirections(std::span<const LightView> views, ReceiverSums& sums) {
    const gl::DebugGroup group(*gl_, "aolib/bake/slabs");
    int used = 0;
    runs_.clear();
    const auto flush = [&] {
        gather(sums);
        runs_.clear();
        used = 0;
    };
    for (const LightView& view : views) {
        const Slabs slabs(view);
        triangles_.begin(slabs);
        const SlabRange range =
            findSlabs(slabs, sums.box(), double{settings_.bias} * computeTexelSide(view));
        for (int first = range.first; first < range.last;) {
            const int count = std::min(range.last - first, pairs_ - used);
            runs_.push_back({&view, slabs, first, count, used});
            if (AoStatus status = drawRun(runs_.back()); !status) {
                return status;
            }
            used += count;
            first += count;
            if (used == pairs_) {
                flush();
            }
        }
    }
    if (used > 0) {
        flush();
    }
    return {};
}

/// Draws the depth maps of a run.
AoStatus SlabPasses::drawRun(const Run& run) {
    if (AoStatus status = triangles_.prepare(std::max(0, run.first - 1), run.first + run.count);
        !status) {
        return status;
    }
    tiles_.begin(run.pair == 0);
    for (int i = 0; i < run.count; ++i) {
        const int slab = run.first + i;
        const int map = 2 * (run.pair + i);
        if (!triangles_.empty(slab)) {
            triangles_.draw(tiles_.beginMap(map, run.slabs.nearest(slab)), slab);
        }
        if (!triangles_.empty(slab - 1)) {
            triangles_.draw(tiles_.beginMap(map + 1, run.slabs.farthest(slab - 1)), slab - 1);
        }
    }
    tiles_.end();
    return {};
}

/// Asks the depth maps of all runs which receivers are lit.
void SlabPasses::gather(ReceiverSums& sums) {
    tiles_.bind(1);
    gatherShader_.bind();
    gatherShader_.set("uDepth", 1);
    gatherShader_.set("uCount", static_cast<int>(runs_.size()));
    gatherShader_.set("uBias", settings_.bias);
    gatherShader_.set("uGround", settings_.ground);
    gatherShader_.set("uTiles", glm::ivec2(tiles_.across(), tiles_.size()));
    std::vector<glm::vec4> axes;
    std::vector<glm::vec4> runs;
    std::vector<glm::vec4> directions;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        const Run& run = runs_[i];
        axes.push_back(run.slabs.axis());
        runs.emplace_back(run.first, run.count, run.pair, float(std::min(run.view->reach, 1e30)));
        directions.emplace_back(glm::vec3(run.view->direction), float(computeTexelSide(*run.view)));
        gatherShader_.set(("uToLight[" + std::to_string(i) + "]").c_str(), run.view->toClip);
    }
    gatherShader_.set("uAxes", std::span<const glm::vec4>(axes));
    gatherShader_.set("uRuns", std::span<const glm::vec4>(runs));
    gatherShader_.set("uDirections", std::span<const glm::vec4>(directions));
    sums.add(gatherShader_);
}

} // namespace aolib::bake
