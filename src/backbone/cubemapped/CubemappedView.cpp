#include "backbone/cubemapped/CubemappedView.h"

#include <algorithm>

namespace aolib {

namespace {

/// From one survey to the next, frames: of a view at rest for which nothing is left to do (the host
/// may draw what it has not described), and of one that moves.
constexpr std::uint64_t kSurveyEveryAtRest = 8;
constexpr std::uint64_t kSurveyEveryMoving = 3;
/// Said of a view that has not converged, at most.
constexpr float kAlmost = 0.99F;

} // namespace

void CubemappedView::cubeMapsChanged() {
    surveys.restart();
    feedbackIsCurrent = false;
    coverageToCome.reset();
    missing.reset();
    cubeMapsBegun();
}

void CubemappedView::cubeMapsBegun() {
    repair.lookAgain();
    isConverged = false;
}

void CubemappedView::restart() {
    repair.restart();
    isConverged = false;
    computed = 0.0F;
}

void CubemappedView::sceneChanged(const std::vector<Scene::Change>& changes, float reach,
                                  bool texels) {
    repair.sceneChanged(changes, reach, texels);
    isConverged = false;
    computed = 0.0F;
}

void CubemappedView::cubeMapGoes(CubeMapProjector& projector) {
    std::erase(used, &projector);
    std::erase(projected, &projector);
    asked.erase(projector.id());
}

void CubemappedView::follow(const Frame& frame, std::uint64_t number) {
    const Sight now{frame.camera, frame.size, frame.clip};
    if (shows != now) {
        shows = now;
        restsSince = number;
        computed = 0.0F;
    }
}

bool CubemappedView::nothingToSurvey() const {
    return isConverged && feedbackIsCurrent && feedback.frame >= convergedIn &&
           feedback.frame >= restsSince;
}

std::uint64_t CubemappedView::framesToSurvey() const {
    if (nothingToSurvey()) {
        return kSurveyEveryAtRest;
    }
    return feedbackIsCurrent && !repair.rests() ? kSurveyEveryMoving : 1;
}

void CubemappedView::noteComputed(float share) {
    computed = isConverged ? 1.0F : std::max(computed, std::min(share, kAlmost));
}

} // namespace aolib
