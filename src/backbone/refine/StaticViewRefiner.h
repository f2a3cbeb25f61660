#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "backbone/estimators/Estimators.h"
#include "backbone/frame/Viewpoint.h"
#include "backbone/refine/AbstractPixelRefiner.h"
#include "scene/Scene.h"

namespace aolib {

/// The last step of a picture, for a view at rest whose cube maps are complete: its pixels are
/// computed themselves, where texels are too coarse. It lasts until the view moves, and
/// holds for a pixel as long as the host draws the same depth there.
class StaticViewRefiner {
public:
    /// Makes a refiner; null for none.
    using Make = std::function<std::unique_ptr<AbstractPixelRefiner>()>;
    /// Begins a frame: drops all pixels when the view, or the kind of refiner, is another than in
    /// the frame before.
    /// @param make  makes a refiner of this kind.
    void beginFrame(const Frame& frame, RefinerKind kind, const Make& make);
    /// Releases the refiner, whose parts are about to go.
    void dropRefiner();
    /// Drops all pixels: the estimate has changed.
    void restart();
    /// Drops the pixels that changes of the scene may alter, and begins anew.
    /// @param reach   of occluders, world units; may be infinite
    /// @param texels  whether texels of cube maps are altered
    void sceneChanged(const std::vector<Scene::Change>& changes, float reach, bool texels);
    /// Begins anew, for the cube maps have changed. Pixels stay until they are replaced.
    void invalidate();

    /// Computes pixels within the budget; only while isStatic(). @param budget  null: to the end
    /// Errors: as AbstractPixelRefiner::step().
    AoStatus advance(const StaticView& view, FrameBudget* budget);
    /// Whether the latest frame showed what the one before had shown.
    bool isStatic() const { return framesAtRest_ > 0; }
    /// Whether nothing is left to refine.
    bool done() const { return refiner_ == nullptr || refiner_->done(); }

    /// What shaders/cubemap/refined.glsl reads; null where nothing is refined.
    const gl::TextureStack* refined() const { return pixels_.texture(); }
    std::size_t pixels() const { return pixels_.count; }
    std::size_t bytes() const {
        return pixels_.bytes() + (refiner_ != nullptr ? refiner_->bytes() : 0);
    }

private:
    std::unique_ptr<AbstractPixelRefiner> refiner_;
    RefinerKind kind_ = RefinerKind::None;
    std::optional<Viewpoint> viewpoint_;
    std::uint64_t framesAtRest_ = 0;
    RefinedPixels pixels_;
};

} // namespace aolib
