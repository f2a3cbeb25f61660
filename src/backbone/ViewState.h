#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "backbone/frame/AppliedTextures.h"
#include "backbone/frame/Frame.h"
#include "backbone/frame/Viewpoint.h"
#include "backbone/passes/Blur.h"
#include "backbone/passes/GeometryBuffer.h"

namespace aolib {

/// What belongs to one view of the host's: the copy of its depth, the pictures of its size. Every
/// strategy derives its own from this.
struct ViewState {
    ViewState() = default;
    virtual ~ViewState() = default;
    ViewState(const ViewState&) = delete;
    ViewState& operator=(const ViewState&) = delete;

    /// GPU memory of all of it.
    virtual std::size_t bytes() const {
        return host.bytes() + geometry.bytes() + applied.bytes() + blurred.bytes();
    }
    /// Whether nothing is left to compute for it.
    virtual bool converged() const { return true; }

    ViewId id{};
    std::optional<Viewpoint> viewpoint; ///< of the latest frame
    std::uint64_t drawn = 0;            ///< number of the latest frame, of all views' frames

    HostFramebuffer host;
    GeometryBuffer geometry; ///< of frames that are not shaded directly
    BlurredPictures blurred; ///< likewise
    AppliedTextures applied;
    std::optional<Frame> latest; ///< its depth is still in `host`
    bool buffered = false;       ///< `blurred` belongs to the latest frame
};

} // namespace aolib
