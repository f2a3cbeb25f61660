#pragma once

#include <array>
#include <vector>

#include "Dice.h"
#include "HostGl.h"
#include "HostObjects.h"

namespace aolib {

/// State that legitimately shapes what aolib computes; a test of results gives it.
struct HostView {
    HostTarget target = HostTarget::Plain;
    std::array<int, 4> viewport{0, 0, HostObjects::kWidth, HostObjects::kHeight};
    std::array<int, 4> scissor{0, 0, HostObjects::kWidth, HostObjects::kHeight};
    bool scissorTest = false;
    bool srgb = false;
    std::array<double, 2> depthRange{0.0, 1.0};
    bool upperLeft = false;
    bool zeroToOne = false;
};

/// Sets every piece of GL state to random unusual but legal values, with real objects bound, or,
/// with calm dice, to what GL starts with.
class Poison {
public:
    Poison(const HostGl& gl, const HostObjects& objects);
    ~Poison() { release(); }
    Poison(const Poison&) = delete;
    Poison& operator=(const Poison&) = delete;

    /// A random view of the kind that only a careless host has.
    HostView randomView(Dice& dice) const;
    /// @param conditional  may also start conditional rendering, which discards aolib's drawing.
    void apply(Dice& dice, const HostView& view, bool conditional = false);
    /// apply() with calm dice.
    void calm(const HostView& view = {});
    /// Ends what runs: queries, transform feedback, conditional rendering, debug groups.
    void release();

private:
    // Each in a file of its own: Poison<Part>.cpp.
    void setSwitches(Dice& dice);
    void setDepthAndStencil(Dice& dice);
    void setRasterisation(Dice& dice);
    void setColour(Dice& dice);
    void setPixelStore(Dice& dice);
    void setViewports(Dice& dice, const HostView& view);
    void bindTextures(Dice& dice);
    void bindBuffers(Dice& dice);
    void bindVertices(Dice& dice);
    void bindFramebuffers(Dice& dice, const HostView& view);
    void setFixedFunction(Dice& dice);
    void setPointsAndArrays(Dice& dice);
    void setMatrices(Dice& dice);
    void pushStacks(Dice& dice);
    void popStacks();
    void setPixelTransfer(Dice& dice);
    void setPrograms(Dice& dice);
    void startQueries(Dice& dice);
    void startFeedback(Dice& dice);
    void pushDebugGroups(Dice& dice);

    GLuint any(Dice& dice, const std::vector<GLuint>& names) const;
    void toggle(GLenum name, bool on) const { on ? gl_.Enable(name) : gl_.Disable(name); }

    const HostGl& gl_;
    const HostObjects& objects_;
    bool debugOutput_ = false; ///< as found
    bool debugSynchronous_ = false;
    std::vector<GLenum> running_; ///< queries
    bool feedback_ = false;
    bool conditional_ = false;
    int debugGroups_ = 0;
    bool stacks_ = false; ///< of matrices and attributes are one deeper
};

} // namespace aolib
