#pragma once

#include <array>
#include <vector>

#include "gl/Functions.h"

namespace aolib::gl {

/// Where the host's fragments go and how they are combined: blending and colour masks of draw
/// buffers, viewports, depth ranges and scissor tests. aolib draws to viewport 0 and mostly to draw
/// buffer 0: the others are taken aside when they are needed.
class OutputState {
public:
    struct Settings {
        bool trustBlending = false;  ///< neither queried nor restored
        bool trustViewports = false; ///< not restored; what a frame reads is queried
        bool everything = true;      ///< all draw buffers and all viewports at once
    };
    OutputState(const Functions& gl, const Settings& settings);
    /// Before drawing to draw buffers 0 ... count - 1: none blends or masks.
    void useTargets(int count);
    /// Draw buffers that are in use by now.
    int targets() const { return used_; }
    void restore() const;

    /// x, y, width, height of viewport 0, pixels, rounded as GL rounds it.
    const std::array<GLint, 4>& viewport() const { return viewport_; }
    /// Near and far of viewport 0.
    const std::array<GLdouble, 2>& depthRange() const { return depthRanges_.front(); }
    /// Scissor test of viewport 0.
    bool scissor() const { return scissors_.front() == GL_TRUE; }

private:
    struct Target {
        GLboolean blend;
        std::array<GLboolean, 4> mask;
        std::array<GLint, 4> factors; ///< source RGB, destination RGB, source A, destination A
        std::array<GLint, 2> equations;
    };

    bool combinesAlone(int target) const;
    Target queried(int target) const;
    void setNeutral(int target) const;
    void restoreTarget(int target) const;
    void saveViewports();
    void restoreViewports() const;

    const Functions& gl_;
    Settings settings_;
    int used_ = 0;
    std::vector<Target> targets_; ///< those used, unless trusted
    std::array<GLint, 4> viewport_{};
    std::vector<std::array<GLfloat, 4>> viewports_;
    std::vector<std::array<GLdouble, 2>> depthRanges_;
    std::vector<GLboolean> scissors_;
};

/// Viewport, depth range and scissor test of viewport 0, in pixels; other viewports stay.
void setViewport(const Functions& gl, int x, int y, int width, int height);
void setDepthRange(const Functions& gl, double near, double far);
void setScissorTest(const Functions& gl, bool enabled);
/// Has draw buffer 0 add up: source and destination, each times its factor.
void beginBlending(const Functions& gl, GLenum source, GLenum destination, GLenum sourceAlpha,
                   GLenum destinationAlpha);
void endBlending(const Functions& gl);
/// Draw buffers that the framebuffer drawn to takes colours for: 1 + the last of them, at least 1.
int drawBuffersInUse(const Functions& gl);

} // namespace aolib::gl
