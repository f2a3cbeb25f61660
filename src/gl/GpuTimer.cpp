#include "gl/GpuTimer.h"

#include <utility>

#include "gl/StateGuard.h"

namespace aolib::gl {

namespace {

/// Times that an answer is asked for in other contexts before it is given up: its own may be gone.
constexpr int kPatience = 64;

/// Takes a query buffer of the host's aside, where no StateGuard has: with one bound, results go
/// into it.
class ResultsToMemory {
public:
    explicit ResultsToMemory(const Functions& gl) : gl_(gl) {
        if (!gl_.capabilities.queryBuffer || gl_.guard != nullptr) {
            return;
        }
        if (!gl_.trusted.pixels) {
            gl_.GetIntegerv(GL_QUERY_BUFFER_BINDING, &buffer_);
        }
        if (buffer_ != 0 || gl_.trusted.pixels) {
            gl_.BindBuffer(GL_QUERY_BUFFER, 0);
        }
    }
    ~ResultsToMemory() {
        if (buffer_ != 0) {
            gl_.BindBuffer(GL_QUERY_BUFFER, static_cast<GLuint>(buffer_));
        }
    }
    ResultsToMemory(const ResultsToMemory&) = delete;
    ResultsToMemory& operator=(const ResultsToMemory&) = delete;

private:
    const Functions& gl_;
    GLint buffer_ = 0;
};

} // namespace

Result<GpuTimer> GpuTimer::create(const Functions& gl) {
    GpuTimer timer;
    timer.gl_ = &gl;
    for (Container& query : timer.queries_) {
        auto made = Container::create(gl, Container::kQuery, "aolib/timer");
        if (!made) {
            return made.status();
        }
        query = std::move(*made);
    }
    return timer;
}

void GpuTimer::begin() {
    milliseconds();
    if (state_ != State::Pending) { // also when what began last never came to its end
        gl_->QueryCounter(queries_[0].name(), GL_TIMESTAMP);
        state_ = State::Running;
        context_ = currentContext(*gl_);
    }
}

void GpuTimer::end() {
    if (state_ == State::Running && context_ == currentContext(*gl_)) {
        gl_->QueryCounter(queries_[1].name(), GL_TIMESTAMP);
        state_ = State::Pending;
    }
}

double GpuTimer::milliseconds() {
    if (state_ != State::Pending) {
        return milliseconds_;
    }
    if (context_ != currentContext(*gl_)) {
        const bool inAnother = currentContext(*gl_) != 0;
        if (inAnother && ++askedElsewhere_ > kPatience) {
            state_ = State::Idle;
        }
        return milliseconds_;
    }
    askedElsewhere_ = 0;
    const ResultsToMemory memory(*gl_); // also asked for outside a StateGuard
    GLint available = GL_FALSE;
    gl_->GetQueryObjectiv(queries_[1].name(), GL_QUERY_RESULT_AVAILABLE, &available);
    if (available == GL_TRUE) {
        GLuint64 start = 0;
        GLuint64 stop = 0;
        gl_->GetQueryObjectui64v(queries_[0].name(), GL_QUERY_RESULT, &start);
        gl_->GetQueryObjectui64v(queries_[1].name(), GL_QUERY_RESULT, &stop);
        milliseconds_ = static_cast<double>(stop - start) * 1e-6;
        state_ = State::Idle;
    }
    return milliseconds_;
}

} // namespace aolib::gl
