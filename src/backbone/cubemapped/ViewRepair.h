#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "backbone/ViewState.h"
#include "backbone/cubemapped/PixelSources.h"
#include "scene/Scene.h"

namespace aolib {

/// The last step of a picture, for a view at rest whose cube maps are complete: its pixels are
/// computed themselves, where texels are too coarse to tell. It lasts until the view moves, and
/// holds for a pixel as long as the host draws the same depth there.
class ViewRepair {
public:
    /// Makes what computes pixels; null for nobody.
    using Make = std::function<std::unique_ptr<AbstractPixelSource>()>;
    /// Notes a frame and what kind of source computes its pixels: forgets everything when either is
    /// another than in the frame before.
    /// @param make  gives a source of this kind.
    void follow(const Frame& frame, PixelSources::Kind kind, const Make& make);
    /// The source is about to go.
    void dropSource();
    /// Forgets everything: what is asked about the scene has changed.
    void restart();
    /// The scene has changed: forgets the pixels that may show it, and looks again.
    /// @param reach   of occluders, world units; may be infinite
    /// @param texels  whether texels of cube maps are altered
    void sceneChanged(const std::vector<Scene::Change>& changes, float reach, bool texels);
    /// The cube maps have changed: looks again. What was found stays shown.
    void lookAgain();

    /// Goes on for as long as the budget lasts, or to the end. Only while `rests()`.
    /// Errors: as AbstractPixelSource::advance().
    AoStatus advance(const RestingView& view, double milliseconds) {
        return source_->advance(view, found_, milliseconds);
    }
    /// Whether the latest frame showed what the one before had shown.
    bool rests() const { return framesAtRest_ > 0; }
    /// Frames before the latest that had its view.
    std::uint64_t framesAtRest() const { return framesAtRest_; }
    /// Whether nothing is left to repair.
    bool done() const { return source_ == nullptr || source_->done(); }

    /// What shaders/cubemap/repaired.glsl reads; null where nothing is repaired.
    const gl::TextureStack* repaired() const { return found_.texture(); }
    std::size_t pixels() const { return found_.count; }
    std::size_t bytes() const {
        return found_.bytes() + (source_ != nullptr ? source_->bytes() : 0);
    }

private:
    std::unique_ptr<AbstractPixelSource> source_;
    PixelSources::Kind kind_ = PixelSources::Kind::None;
    std::optional<Sight> sight_;
    std::uint64_t framesAtRest_ = 0;
    FoundPixels found_;
};

} // namespace aolib
