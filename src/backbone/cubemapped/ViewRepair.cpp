#include "backbone/cubemapped/ViewRepair.h"

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

} // namespace

void ViewRepair::follow(const Frame& frame, PixelSources::Kind kind, const Make& make) {
    const Sight sight{frame.camera, frame.size, frame.clip};
    if (sight_ == sight && kind_ == kind) {
        ++framesAtRest_;
        return;
    }
    restart();
    if (kind_ != kind) {
        source_ = kind == PixelSources::Kind::None ? nullptr : make();
        kind_ = kind;
    }
    sight_ = sight;
    framesAtRest_ = 0;
}

void ViewRepair::dropSource() {
    restart();
    source_.reset();
    kind_ = PixelSources::Kind::None;
}

void ViewRepair::restart() {
    found_.drop();
    if (source_ != nullptr) {
        source_->restart();
    }
}

void ViewRepair::sceneChanged(const std::vector<Scene::Change>& changes, float reach, bool texels) {
    bool altered = false;
    for (const Scene::Change& change : changes) {
        const Bounds within = change.region.inflated(reach);
        if (sight_ && source_ != nullptr && !within.empty() && source_->isAltered(within, texels)) {
            const Rectangle pixels =
                pixelsOf(within, sight_->camera, sight_->size, sight_->clip.upperLeft);
            found_.drop(pixels.low, pixels.high - pixels.low);
            altered = true;
        }
    }
    if (altered) {
        source_->restart();
    }
}

void ViewRepair::lookAgain() {
    if (source_ != nullptr) {
        source_->lookAgain();
    }
}

} // namespace aolib
