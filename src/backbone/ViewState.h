#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "backbone/AppliedTextures.h"
#include "backbone/Frame.h"
#include "backbone/GeometryBuffer.h"
#include "gl/RenderToTexture2D.h"

namespace aolib {

/// What is seen through and how large: two frames of it show the same, if the scene is the same.
struct Sight {
    HostCamera camera;
    glm::ivec2 size;
    ClipConvention clip;

    bool operator==(const Sight&) const = default;
};

/// What belongs to one view of the host's: the copy of its depth, the pictures of its size. Every
/// strategy derives its own from this.
struct ViewState {
    ViewState() = default;
    virtual ~ViewState() = default;
    ViewState(const ViewState&) = delete;
    ViewState& operator=(const ViewState&) = delete;

    /// GPU memory of all of it.
    virtual std::size_t bytes() const {
        return host.bytes() + geometry.bytes() + applied.bytes() +
               (blurredRows ? blurredRows.bytes() : 0) + (visibility ? visibility.bytes() : 0);
    }
    /// Whether nothing is left to compute for it.
    virtual bool converged() const { return true; }

    ViewId id{};
    std::optional<Sight> sight; ///< of the latest frame
    std::uint64_t drawn = 0;    ///< number of the latest frame, of all views' frames

    HostFramebuffer host;
    GeometryBuffer geometry;           ///< of frames that are not shaded directly
    gl::RenderToTexture2D blurredRows; ///< likewise
    gl::RenderToTexture2D visibility;  ///< W (-1 background), shaded; size of the frame
    AppliedTextures applied;
    std::optional<Frame> latest; ///< its depth is still in `host`
    bool buffered = false;       ///< `visibility` belongs to the latest frame
};

} // namespace aolib
