#pragma once

namespace aolib::viewer {

/// The line between the two parts of the picture, and the mouse that drags it.
class SplitLine {
public:
    /// @param share  of the picture's width that lies left of the line, 0 to 1.
    explicit SplitLine(float share = 0.5F) { place(share); }

    /// @param x        of the mouse, pixels from the left.
    /// @param width    of the picture, pixels.
    /// @param pressed  the button went down on the picture.
    /// @param held     it is still down.
    /// Returns whether the line has moved.
    bool follow(float x, float width, bool pressed, bool held);

    void place(float share);
    float share() const { return share_; }
    /// Whether a press here takes hold of the line.
    bool near(float x, float width) const;
    bool dragging() const { return dragging_; }

private:
    float share_ = 0.5F;
    float grip_ = 0.0F; ///< from the line to the mouse when it took hold, pixels
    bool dragging_ = false;
};

} // namespace aolib::viewer
