#pragma once

#include "viewer/Input.h"

namespace aolib::viewer {

/// The line between the two parts of the picture, and the mouse that drags it.
class SplitLine {
public:
    /// @param share  of the picture's width that lies left of the line, 0 to 1.
    explicit SplitLine(float share = 0.5F) { place(share); }

    /// @param left   what the left button did since the last call.
    /// @param width  of the picture, mouse pixels.
    /// Returns whether the line has moved.
    bool follow(const ButtonDrag& left, float width);

    void place(float share);
    float share() const { return share_; }
    /// Whether a press here takes hold of the line.
    bool near(float x, float width) const;
    /// Whether what the button did in the last follow() moved the line, or might have.
    bool dragging() const { return dragging_; }

private:
    float share_ = 0.5F;
    float grip_ = 0.0F; ///< from the line to the mouse when it took hold, pixels
    bool dragging_ = false;
    bool held_ = false; ///< the button was down at the end of the last follow()
};

} // namespace aolib::viewer
