#include "backbone/CubemappedView.h"

#include <algorithm>

namespace aolib {

namespace {

/// Frames from one feedback pass to the next: of a view at rest for which nothing is left to do
/// (the host may draw what it has not described), and of one that moves.
constexpr std::uint64_t kFeedbackIntervalAtRest = 8;
constexpr std::uint64_t kFeedbackIntervalMoving = 3;
/// Said of a view that has not converged, at most.
constexpr float kAlmost = 0.99F;

} // namespace

void CubemappedView::cubeMapsChanged() {
    pendingFeedback.restart();
    feedbackIsCurrent = false;
    predictedCoverage.reset();
    missing.reset();
    cubeMapsBegun();
}

void CubemappedView::cubeMapsBegun() {
    refiner.invalidate();
    isConverged = false;
}

void CubemappedView::restart() {
    refiner.restart();
    isConverged = false;
    computed = 0.0F;
}

void CubemappedView::sceneChanged(const std::vector<Scene::Change>& changes, float reach,
                                  bool texels) {
    refiner.sceneChanged(changes, reach, texels);
    isConverged = false;
    computed = 0.0F;
}

void CubemappedView::forgetCubeMap(CubeMapProjector& projector) {
    std::erase(used, &projector);
    std::erase(projected, &projector);
    requested.erase(projector.id());
}

void CubemappedView::beginFrame(const Frame& frame, std::uint64_t number) {
    const Viewpoint now{frame.camera, frame.size, frame.clip};
    if (shows != now) {
        shows = now;
        restsSince = number;
        computed = 0.0F;
    }
}

bool CubemappedView::feedbackIsUpToDate() const {
    return isConverged && feedbackIsCurrent && feedback.frame >= convergedIn &&
           feedback.frame >= restsSince;
}

std::uint64_t CubemappedView::feedbackInterval() const {
    if (feedbackIsUpToDate()) {
        return kFeedbackIntervalAtRest;
    }
    return feedbackIsCurrent && !refiner.isStatic() ? kFeedbackIntervalMoving : 1;
}

void CubemappedView::noteComputed(float share) {
    computed = isConverged ? 1.0F : std::max(computed, std::min(share, kAlmost));
}

} // namespace aolib
