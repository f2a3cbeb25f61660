#include "backbone/refine/StaticViewRefiner.h"

#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

namespace aolib {

namespace {

struct Rectangle {
    glm::ivec2 low;  ///< pixels
    glm::ivec2 high; ///< one beyond the last
};

/// Pixels that may show something of a box: all of them where a part of it lies beside the eye or
/// behind.
Rectangle pixelsOf(const Bounds& box, const HostCamera& camera, const glm::ivec2& size, bool flip) {
    glm::dvec2 low(1.0);
    glm::dvec2 high(-1.0);
    for (unsigned corner = 0; corner < 8; ++corner) {
        const glm::dvec3 eye =
            (glm::dvec3(box.corner(corner)) - camera.eye()) * camera.eyeToWorld();
        const glm::dvec4 clip = camera.projection() * glm::dvec4(eye, 1.0);
        const glm::dvec2 at = glm::dvec2(clip) / clip.w;
        if (!(clip.w > 0.0) || !std::isfinite(at.x) || !std::isfinite(at.y)) {
            return {glm::ivec2(0), size};
        }
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    if (flip) {
        low.y = -std::exchange(high.y, -low.y);
    }
    const auto toPixel = [&](const glm::dvec2& at) {
        return (glm::clamp(at, -1.0, 1.0) * 0.5 + 0.5) * glm::dvec2(size);
    };
    return {glm::ivec2(glm::floor(toPixel(low))), glm::ivec2(glm::ceil(toPixel(high)))};
}

/// A refiner's work on a view.
class RefineJob final : public AbstractJob {
public:
    RefineJob(AbstractPixelRefiner& refiner, const StaticView& view, RefinedPixels& pixels)
        : refiner_(refiner), view_(view), pixels_(pixels) {}

    std::optional<WorkUnit> next() override { return refiner_.next(); }
    bool isReady() override { return refiner_.isReady(); }
    Result<int> step(int most) override { return refiner_.step(view_, pixels_, most); }
    void await(double milliseconds) override { refiner_.await(view_, milliseconds); }

private:
    AbstractPixelRefiner& refiner_;
    const StaticView& view_;
    RefinedPixels& pixels_;
};

} // namespace

AoStatus StaticViewRefiner::advance(const StaticView& view, FrameBudget* budget) {
    RefineJob job(*refiner_, view, pixels_);
    return budget == nullptr ? runToEnd(job) : runWithinBudget(*budget, job).status();
}

void StaticViewRefiner::beginFrame(const Frame& frame, RefinerKind kind, const Make& make) {
    const Viewpoint viewpoint{frame.camera, frame.size, frame.clip};
    if (viewpoint_ == viewpoint && kind_ == kind) {
        ++framesAtRest_;
        return;
    }
    restart();
    if (kind_ != kind) {
        refiner_ = kind == RefinerKind::None ? nullptr : make();
        kind_ = kind;
    }
    viewpoint_ = viewpoint;
    framesAtRest_ = 0;
}

void StaticViewRefiner::dropRefiner() {
    restart();
    refiner_.reset();
    kind_ = RefinerKind::None;
}

void StaticViewRefiner::restart() {
    pixels_.drop();
    if (refiner_ != nullptr) {
        refiner_->restart();
    }
}

void StaticViewRefiner::sceneChanged(const std::vector<Scene::Change>& changes, float reach,
                                     bool texels) {
    bool altered = false;
    for (const Scene::Change& change : changes) {
        const Bounds within = change.region.inflated(reach);
        if (viewpoint_ && refiner_ != nullptr && !within.empty() &&
            refiner_->isAltered(within, texels)) {
            const Rectangle pixels =
                pixelsOf(within, viewpoint_->camera, viewpoint_->size, viewpoint_->clip.upperLeft);
            pixels_.drop(pixels.low, pixels.high - pixels.low);
            altered = true;
        }
    }
    if (altered) {
        refiner_->restart();
    }
}

void StaticViewRefiner::invalidate() {
    if (refiner_ != nullptr) {
        refiner_->invalidate();
    }
}

} // namespace aolib
