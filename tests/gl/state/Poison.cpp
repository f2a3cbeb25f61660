#include "Poison.h"

namespace aolib {

Poison::Poison(const HostGl& gl, const HostObjects& objects) : gl_(gl), objects_(objects) {
    if (gl_.has.debug) {
        debugOutput_ = gl_.IsEnabled(GL_DEBUG_OUTPUT) == GL_TRUE;
        debugSynchronous_ = gl_.IsEnabled(GL_DEBUG_OUTPUT_SYNCHRONOUS) == GL_TRUE;
    }
}

HostView Poison::randomView(Dice& dice) const {
    HostView view;
    view.target = static_cast<HostTarget>(dice.below(kHostTargets));
    if (dice.chance(0.5)) {
        view.viewport = {dice.between(-3, 8), dice.between(-3, 8),
                         dice.chance(0.1) ? 0 : dice.between(1, 40), dice.between(1, 24)};
    }
    view.scissorTest = dice.flag(false);
    view.scissor = {dice.between(0, 8), dice.between(0, 8), dice.between(0, 32),
                    dice.between(0, 18)};
    view.srgb = dice.flag(false);
    view.depthRange = dice.pick<std::array<double, 2>>(
        {0.0, 1.0}, {{1.0, 0.0}, {0.25, 0.75}, {0.5, 0.5}, {0.0, 0.125}});
    view.upperLeft = gl_.has.clipControl && dice.flag(false);
    view.zeroToOne = gl_.has.clipControl && dice.flag(false);
    return view;
}

void Poison::calm(const HostView& view) {
    Dice dice = Dice::calm();
    apply(dice, view);
}

void Poison::apply(Dice& dice, const HostView& view, bool conditional) {
    release();
    setSwitches(dice);
    setDepthAndStencil(dice);
    setRasterisation(dice);
    setColour(dice);
    setPixelStore(dice);
    setViewports(dice, view);
    toggle(GL_FRAMEBUFFER_SRGB, view.srgb);
    bindBuffers(dice);
    bindTextures(dice);
    bindVertices(dice);
    bindFramebuffers(dice, view);
    if (gl_.has.compatibility) {
        setFixedFunction(dice);
        setPointsAndArrays(dice);
        setMatrices(dice);
        setPixelTransfer(dice);
        pushStacks(dice);
    }
    setPrograms(dice);
    pushDebugGroups(dice);
    startQueries(dice);
    startFeedback(dice);
    if (conditional && dice.unusual()) {
        gl_.BeginConditionalRender(objects_.emptyQuery, GL_QUERY_WAIT);
        conditional_ = true;
    }
}

void Poison::release() {
    if (conditional_) {
        gl_.EndConditionalRender();
    }
    if (feedback_) {
        gl_.EndTransformFeedback();
    }
    for (const GLenum target : running_) {
        gl_.EndQuery(target);
    }
    for (; debugGroups_ > 0; --debugGroups_) {
        gl_.PopDebugGroup();
    }
    if (stacks_) {
        popStacks();
    }
    conditional_ = feedback_ = false;
    running_.clear();
}

void Poison::setPrograms(Dice& dice) {
    if (gl_.has.separatePrograms) {
        gl_.UseProgram(0); // Mesa 22 does not unbind a pipeline while a program is in use
        gl_.BindProgramPipeline(any(dice, objects_.pipelines));
    }
    gl_.UseProgram(dice.pick(0U, {objects_.program, objects_.feedbackProgram}));
}

void Poison::pushDebugGroups(Dice& dice) {
    if (!gl_.has.debug || !dice.unusual()) {
        return;
    }
    // The default group counts: to the brim, one below, or few.
    const int room = gl_.has.debugGroups - 1;
    debugGroups_ = dice.chance(0.4) ? room : dice.chance(0.5) ? room - 1 : dice.between(1, room);
    for (int i = 0; i < debugGroups_; ++i) {
        gl_.PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, static_cast<GLuint>(i), -1, "host");
    }
}

void Poison::startQueries(Dice& dice) {
    // The occlusion queries exclude each other.
    const GLenum occlusion = objects_.queries.count(GL_ANY_SAMPLES_PASSED_CONSERVATIVE) != 0
                                 ? dice.pick<GLenum>(0, {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED,
                                                         GL_ANY_SAMPLES_PASSED_CONSERVATIVE})
                                 : dice.pick<GLenum>(0, {GL_SAMPLES_PASSED, GL_ANY_SAMPLES_PASSED});
    const auto start = [&](GLenum target) {
        gl_.BeginQuery(target, objects_.queries.at(target));
        running_.push_back(target);
    };
    if (occlusion != 0) {
        start(occlusion);
    }
    for (const GLenum target : GLenums{GL_PRIMITIVES_GENERATED,
                                       GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, GL_TIME_ELAPSED}) {
        if (dice.unusual()) {
            start(target);
        }
    }
}

void Poison::startFeedback(Dice& dice) {
    if (gl_.has.transformFeedback2) {
        gl_.BindTransformFeedback(GL_TRANSFORM_FEEDBACK, any(dice, objects_.feedbacks));
    }
    for (GLuint i = 0; i < 4; ++i) {
        gl_.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, i, any(dice, objects_.feedbackBuffers));
    }
    gl_.BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, any(dice, objects_.feedbackBuffers));
    if (!gl_.has.transformFeedback2 || !dice.unusual()) {
        return;
    }
    gl_.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, objects_.feedbackBuffers.front());
    gl_.UseProgram(objects_.feedbackProgram);
    gl_.BeginTransformFeedback(GL_POINTS);
    feedback_ = true;
    if (dice.chance(0.4)) {
        gl_.PauseTransformFeedback();
        gl_.UseProgram(dice.pick(objects_.feedbackProgram, {objects_.program, 0U}));
    }
}

GLuint Poison::any(Dice& dice, const std::vector<GLuint>& names) const {
    return dice.unusual() && !names.empty() ? names[dice.below(names.size())] : 0;
}

} // namespace aolib
