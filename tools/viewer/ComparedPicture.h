#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "viewer/FrameTimes.h"
#include "viewer/LitPicture.h"
#include "viewer/OptionTexts.h"
#include "viewer/SceneInstance.h"
#include "viewer/SplitPicture.h"
#include "viewer/TracedPicture.h"
#include "viewer/TruthWorker.h"
#include "viewer/ViewerState.h"

namespace aolib::viewer {

/// What a picture may be compared with that takes a while to be had.
struct References {
    std::shared_ptr<const TracedTruth> truth; ///< null until there is one of this view
    Light light;
};

/// The picture and what it is compared with, each drawn only when it would change. Context: the
/// window's, for every call.
class ComparedPicture {
public:
    /// @param gl  must outlive it. Errors: ShaderError.
    static Result<ComparedPicture> create(const gl::Functions& gl);

    /// Draws what is out of date. Notes the error against the truth in the state.
    /// @param times  gets the frame's, if the state has it measured.
    /// Returns whether anything was drawn. Errors: the library's; it is not tried again until
    /// something changes.
    Result<bool> draw(SceneInstance& scene, ViewerState& state, const glm::ivec2& pixels,
                      const References& references, FrameTimes& times);
    /// Whether another draw() of the same would show the same.
    bool settled() const { return settled_; }

    /// Whether it shows something else than what is wanted, rather than the same less well.
    bool outdated(const ViewerState& state, const glm::ivec2& pixels,
                  const References& references) const;

    /// Copies it to the window.
    void present(const ViewerState& state) const;
    /// Another scene: what is drawn is out of date.
    void forget() { drawn_.reset(); }

private:
    /// All that a picture depends on.
    struct Basis {
        NamedCamera camera;
        std::vector<OptionText> options;
        bool occlusion = true;
        glm::ivec2 pixels{0};
        ComparedMethod compared = ComparedMethod::None;
        References references;

        bool sameLeft(const Basis& other) const;
        bool sameRight(const Basis& other) const;
    };

    static Basis basisOf(const ViewerState& state, const glm::ivec2& pixels,
                         const References& references);
    explicit ComparedPicture(const gl::Functions& gl) : split_(gl) {}
    AoStatus drawLeft(SceneInstance& scene, const ViewerState& state, FrameTimes& times);
    AoStatus drawRight(SceneInstance& scene, const ViewerState& state,
                       const References& references);
    AoStatus showTruth(SceneInstance& scene, const ViewerState& state, const TracedTruth* truth,
                       const host::HostFramebuffer& target);
    AoStatus measureError(SceneInstance& scene, ViewerState& state, const TracedTruth* truth);

    SplitPicture split_;
    TracedPicture traced_;
    LitPicture lit_;
    std::optional<Basis> drawn_;
    std::optional<ByteImage> difference_;
    bool settled_ = false;
    bool measuredAtRest_ = false; ///< the error is of what is shown for good
};

} // namespace aolib::viewer
