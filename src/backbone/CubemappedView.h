#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "backbone/ViewState.h"
#include "backbone/passes/FeedbackPass.h"
#include "backbone/refine/StaticViewRefiner.h"

namespace aolib {

/// What one view has of the cube maps, which all views share: the tiles that it requests, the
/// coverage that it is missing, and the pixels that were refined for it.
struct CubemappedView final : ViewState {
    explicit CubemappedView(unsigned number) : slot(number) {}

    std::size_t bytes() const override {
        return ViewState::bytes() + pictures.bytes() + refiner.bytes();
    }
    bool converged() const override { return isConverged; }

    /// Cube maps have come or gone: what was found out about them is out of date.
    void cubeMapsChanged();
    /// Cube maps are computed anew, as they stand.
    void cubeMapsBegun();
    /// Restarts its refinement: the estimate has changed.
    void restart();
    /// The scene has changed.
    /// @param reach   of occluders, world units; may be infinite
    /// @param texels  whether texels of cube maps are altered
    void sceneChanged(const std::vector<Scene::Change>& changes, float reach, bool texels);
    /// A cube map is about to go.
    void forgetCubeMap(CubeMapProjector& projector);

    /// Notes a frame: a view that shows something else begins anew.
    /// @param number  of the frame, when it has ended
    void beginFrame(const Frame& frame, std::uint64_t number);
    /// Whether feedback has arrived of what the latest frame shows.
    bool hasFeedback() const { return feedback.frame > 0 && feedback.frame >= restsSince; }
    /// Whether the latest feedback is of this view, as it is now that nothing is left to compute.
    bool feedbackIsUpToDate() const;
    /// Frames of this view from one feedback pass to the next.
    std::uint64_t feedbackInterval() const;
    /// Notes how much is computed. @param share  of the passes that are needed, as far as is known
    void noteComputed(float share);

    const unsigned slot; ///< in the tracer's queue, which no other view has
    StaticViewRefiner refiner;
    ProjectedPictures pictures;
    /// What computeVisibility() projected last, of `pictures`; null before the first.
    const gl::RenderToTexture2D* latestBest = nullptr;

    PendingFeedback pendingFeedback;
    FeedbackResult feedback;        ///< the latest that has arrived; frame 0 before the first
    bool feedbackIsCurrent = false; ///< no cube map has come or gone since
    /// Share of the surfaces that are shaded, or may be once pending tiles are computed.
    std::optional<float> predictedCoverage;
    std::optional<glm::vec3> missing; ///< a surface that is not, world units

    std::map<CubeMapId, TileSet> requested;
    std::vector<CubeMapProjector*> used;      ///< in the latest frame, the most important first
    std::vector<CubeMapProjector*> projected; ///< of these, those that are shown
    std::optional<Viewpoint> shows;           ///< what the latest frame showed
    std::uint64_t frames = 0;                 ///< of this view, ended
    std::uint64_t restsSince = 0;             ///< number of the first frame that showed the same
    bool texelsComplete = false;   ///< of the cube maps in use, as far as the view requests them
    bool isConverged = false;      ///< and nothing is left to refine
    std::uint64_t convergedIn = 0; ///< number of the frame in which that came true
    float computed = 0.0F;         ///< largest share since the view, scene or options changed
};

} // namespace aolib
