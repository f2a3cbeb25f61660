#pragma once

#include <array>
#include <vector>

#include "gl/Functions.h"

namespace aolib::gl {

/// Where the host's fragments go and how they are combined: blending and colour masks of each draw
/// buffer, viewports and depth ranges. Taken by query when it is made.
class OutputState {
public:
    explicit OutputState(const Functions& gl);
    void restore(const Functions& gl) const;

    /// x, y, width, height of viewport 0, pixels, rounded as GL rounds it.
    const std::array<GLint, 4>& viewport() const { return viewport_; }

    /// Near and far of viewport 0.
    const std::array<GLdouble, 2>& depthRange() const { return depthRanges_.front(); }

private:
    struct BlendState {
        std::array<GLint, 4> factors; ///< source RGB, destination RGB, source A, destination A
        std::array<GLint, 2> equations;
    };

    void saveBlendState(const Functions& gl);
    void saveViewports(const Functions& gl);
    void restoreBlendState(const Functions& gl) const;
    void restoreViewports(const Functions& gl) const;

    std::vector<BlendState> blend_; ///< one per draw buffer, or one for all
    std::vector<std::array<GLboolean, 4>> colorMasks_;
    std::array<GLint, 4> viewport_{};
    std::vector<std::array<GLfloat, 4>> viewports_;
    std::vector<std::array<GLdouble, 2>> depthRanges_;
};

} // namespace aolib::gl
