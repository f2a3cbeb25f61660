#include "gl/GpuTimer.h"

namespace aolib::gl {

namespace {

/// Takes a query buffer of the host's aside: with one bound, results go into it.
class ResultsToMemory {
public:
    explicit ResultsToMemory(const Functions& gl) : gl_(gl) {
        if (gl_.capabilities.queryBuffer) {
            gl_.GetIntegerv(GL_QUERY_BUFFER_BINDING, &buffer_);
        }
        if (buffer_ != 0) {
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
    for (Query& query : timer.queries_) {
        query = generate<Query>(gl, &Functions::GenQueries);
        if (!query) {
            return AoStatus(StatusCode::OutOfMemory, "GL gave no query name for a timer");
        }
    }
    return timer;
}

void GpuTimer::begin() {
    milliseconds();
    if (state_ != State::Pending) { // also when what began last never came to its end
        gl_->QueryCounter(queries_[0].name(), GL_TIMESTAMP);
        state_ = State::Running;
    }
}

void GpuTimer::end() {
    if (state_ == State::Running) {
        gl_->QueryCounter(queries_[1].name(), GL_TIMESTAMP);
        state_ = State::Pending;
    }
}

double GpuTimer::milliseconds() {
    if (state_ != State::Pending) {
        return milliseconds_;
    }
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
