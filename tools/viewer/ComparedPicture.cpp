#include "viewer/ComparedPicture.h"

#include <cmath>
#include <utility>

#include "image/DifferencePicture.h"

namespace aolib::viewer {

namespace {

/// The difference of W that is shown in full colour.
constexpr float kFullDifference = 0.25F;

bool same(const NamedCamera& a, const NamedCamera& b) {
    return a.eye == b.eye && a.target == b.target && a.up == b.up && a.fovyDeg == b.fovyDeg &&
           a.near == b.near && a.far == b.far;
}

} // namespace

bool ComparedPicture::Basis::sameLeft(const Basis& other) const {
    return same(camera, other.camera) && options == other.options && occlusion == other.occlusion &&
           pixels == other.pixels;
}

bool ComparedPicture::Basis::sameRight(const Basis& other) const {
    return same(camera, other.camera) && options == other.options && pixels == other.pixels &&
           compared == other.compared && references.truth == other.references.truth &&
           references.light == other.references.light;
}

Result<ComparedPicture> ComparedPicture::create(const gl::Functions& gl) {
    Result<TracedPicture> traced = TracedPicture::create(gl);
    if (!traced) {
        return traced.status();
    }
    ComparedPicture picture(gl);
    picture.traced_ = std::move(*traced);
    return picture;
}

ComparedPicture::Basis ComparedPicture::basisOf(const ViewerState& state, const glm::ivec2& pixels,
                                                const References& references) {
    return {state.camera.camera(), optionTexts(state.options),
            state.occlusion,       pixels,
            state.compared,        references};
}

bool ComparedPicture::outdated(const ViewerState& state, const glm::ivec2& pixels,
                               const References& references) const {
    const Basis wanted = basisOf(state, pixels, references);
    return !drawn_ || !wanted.sameLeft(*drawn_) || !wanted.sameRight(*drawn_);
}

Result<bool> ComparedPicture::draw(SceneInstance& scene, ViewerState& state,
                                   const glm::ivec2& pixels, const References& references,
                                   FrameTimes& times) {
    const Basis wanted = basisOf(state, pixels, references);
    const std::shared_ptr<const TracedTruth>& truth = references.truth;
    const bool left = !drawn_ || !wanted.sameLeft(*drawn_) || !settled_;
    const bool right = !drawn_ || !wanted.sameRight(*drawn_);
    const bool otherTruth =
        !drawn_ || drawn_->references.truth != truth || drawn_->compared != state.compared;
    drawn_ = wanted;
    if (!left && !right) {
        return false;
    }
    settled_ = true; // so that a failure is not tried again and again
    if (AoStatus status = split_.resize(pixels); !status) {
        return status;
    }
    scene.look(wanted.camera, static_cast<float>(pixels.x) / static_cast<float>(pixels.y));
    if (left) {
        measuredAtRest_ = false;
        if (AoStatus status = drawLeft(scene, state, times); !status) {
            return status;
        }
        settled_ = !state.occlusion || scene.settled();
    }
    if (otherTruth || (settled_ && !measuredAtRest_)) {
        if (AoStatus status = measureError(scene, state, truth.get()); !status) {
            return status;
        }
        measuredAtRest_ = settled_;
    }
    if (right || state.compared == ComparedMethod::Difference) {
        if (AoStatus status = drawRight(scene, state, references); !status) {
            return status;
        }
    }
    return true;
}

AoStatus ComparedPicture::drawLeft(SceneInstance& scene, const ViewerState& state,
                                   FrameTimes& times) {
    if (!state.occlusion) {
        scene.drawPlain(split_.left());
        return {};
    }
    std::vector<bench::PassTime> passes;
    const AoStatus status =
        scene.drawShaded(split_.left(), state.options, state.measuring ? &passes : nullptr);
    if (state.measuring && status) {
        times.add(std::move(passes));
    }
    return status;
}

AoStatus ComparedPicture::measureError(SceneInstance& scene, ViewerState& state,
                                       const TracedTruth* truth) {
    state.error.reset();
    difference_.reset();
    if (truth == nullptr || !state.occlusion || !needsTruth(state.compared)) {
        return {};
    }
    Result<VisibilityImage> read = scene.ao().readVisibility();
    if (!read) {
        return read.status();
    }
    FloatImage visibility(read->width, read->height, 1);
    visibility.pixels = std::move(read->visibility);
    state.error = viewError(visibility, truth->visibility, truth->noise);
    if (state.compared == ComparedMethod::Difference && state.error) {
        if (auto picture = differencePicture(visibility, truth->visibility, kFullDifference)) {
            difference_ = std::move(*picture);
        }
    }
    return {};
}

AoStatus ComparedPicture::drawRight(SceneInstance& scene, const ViewerState& state,
                                    const References& references) {
    if (state.compared == ComparedMethod::None) {
        return {};
    }
    const Result<const host::HostFramebuffer*> target = split_.right();
    if (!target) {
        return target.status();
    }
    switch (state.compared) {
    case ComparedMethod::ScreenSpace:
        return scene.drawScreenSpace(**target, state.options);
    case ComparedMethod::Truth:
        return showTruth(scene, state, references.truth.get(), **target);
    case ComparedMethod::Difference:
        if (difference_) {
            (*target)->bind();
            traced_.upload(*difference_);
            traced_.show();
            return {};
        }
        break;
    case ComparedMethod::Environment:
        if (references.light.ready()) {
            return lit_.draw(scene.session(), references.light, scene.viewMatrix(),
                             scene.projection(), **target, traced_);
        }
        break;
    case ComparedMethod::None:
    case ComparedMethod::Host:
        break;
    }
    scene.drawPlain(**target);
    return {};
}

AoStatus ComparedPicture::showTruth(SceneInstance& scene, const ViewerState& state,
                                    const TracedTruth* truth, const host::HostFramebuffer& target) {
    if (truth == nullptr) {
        scene.drawPlain(target);
        return {};
    }
    traced_.upload(truth->visibility);
    if (state.options.debugView == DebugView::AmbientOcclusion) {
        target.bind();
        traced_.show();
    } else {
        scene.drawPlain(target);
        traced_.darken(state.options.contrast);
    }
    return {};
}

void ComparedPicture::present(const ViewerState& state) const {
    const int width = split_.size().x;
    const int column =
        static_cast<int>(std::lround(state.split.share() * static_cast<float>(width)));
    split_.present(state.compared == ComparedMethod::None ? width : column);
}

} // namespace aolib::viewer
