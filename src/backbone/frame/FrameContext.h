#pragma once

#include "backbone/frame/Frame.h"
#include "backbone/frame/HostFramebuffer.h"

namespace aolib {

/// What the passes of one frame of one view read. Made once a frame.
struct FrameContext : BackboneContext {
    FrameContext(const BackboneContext& backbone, const Frame& of, const HostFramebuffer& from)
        : BackboneContext(backbone), frame(of), host(from) {}

    const Frame& frame;
    const HostFramebuffer& host; ///< holds the frame's depth
};

} // namespace aolib
