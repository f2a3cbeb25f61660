// The light of an environment: which one, and what it needs to be known of the scene.
#include <utility>

#include "content/EnvironmentSource.h"
#include "viewer/Viewer.h"

namespace aolib::viewer {

void Viewer::followLight() {
    if (state_.compared != ComparedMethod::Environment) {
        // What is baked is kept: it is true as long as the scene is there.
        if (lightState_.working) {
            lightWorker_.stop();
        }
        lightState_ = lightWorker_.state();
        return;
    }
    if (state_.environment != environmentName_) {
        Result<lighting::EnvironmentMap, LoadError> map = openEnvironment(state_.environment);
        if (map) {
            environment_ = std::make_shared<const lighting::EnvironmentMap>(std::move(*map));
            environmentName_ = state_.environment;
        } else {
            messages_.warn(map.error().sentence);
            state_.environment = environmentName_; // as it was
        }
        guiFrames_ = std::max(guiFrames_, 2);
    }
    lightWorker_.follow(scene_->view().model);
    lightState_ = lightWorker_.state();
}

References Viewer::references() const {
    return {truthState_.truth, {lightState_.scene, environment_, state_.turn, state_.stops}};
}

} // namespace aolib::viewer
