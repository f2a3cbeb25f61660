#include "bench/PassTimer.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "bench/Spread.h"
#include "gl/Functions.h"

namespace aolib::bench {

namespace {

constexpr const char* kOther = "other";
constexpr std::string_view kPrefix = "aolib: ";

PassTime& timeOf(std::vector<PassTime>& times, const std::string& pass) {
    const auto found = std::find_if(times.begin(), times.end(),
                                    [&](const PassTime& time) { return time.pass == pass; });
    if (found != times.end()) {
        return *found;
    }
    times.push_back({pass, 0.0});
    return times.back();
}

} // namespace

struct PassTimer::Functions {
    PFNGLPUSHDEBUGGROUPPROC push = nullptr;
    PFNGLPOPDEBUGGROUPPROC pop = nullptr;
    PFNGLFINISHPROC finish = nullptr;

    static thread_local PassTimer* current;

    static void APIENTRY pushGroup(GLenum source, GLuint id, GLsizei length,
                                   const GLchar* message) {
        current->functions_->push(source, id, length, message);
        std::string_view name =
            length < 0 ? std::string_view(message) : std::string_view(message, std::size_t(length));
        name.remove_prefix(name.starts_with(kPrefix) ? kPrefix.size() : 0);
        current->enter(std::string(name));
    }
    static void APIENTRY popGroup() {
        current->leave();
        current->functions_->pop();
    }
};

thread_local PassTimer* PassTimer::Functions::current = nullptr;

PassTimer::PassTimer() : functions_(std::make_unique<Functions>()) {
    Functions::current = this;
}

PassTimer::~PassTimer() {
    Functions::current = nullptr;
}

ProcAddressLoader PassTimer::wrap(const ProcAddressLoader& loader) {
    functions_->push = reinterpret_cast<PFNGLPUSHDEBUGGROUPPROC>(loader("glPushDebugGroup"));
    functions_->pop = reinterpret_cast<PFNGLPOPDEBUGGROUPPROC>(loader("glPopDebugGroup"));
    functions_->finish = reinterpret_cast<PFNGLFINISHPROC>(loader("glFinish"));
    if (functions_->push == nullptr || functions_->pop == nullptr ||
        functions_->finish == nullptr) {
        return loader; // no groups in this context: everything will be "other"
    }
    return [loader](const char* name) -> void* {
        if (std::strcmp(name, "glPushDebugGroup") == 0) {
            return reinterpret_cast<void*>(&Functions::pushGroup);
        }
        if (std::strcmp(name, "glPopDebugGroup") == 0) {
            return reinterpret_cast<void*>(&Functions::popGroup);
        }
        return loader(name);
    };
}

void PassTimer::start() {
    times_.clear();
    stack_.clear();
    running_ = true;
    last_ = Clock::now();
}

std::vector<PassTime> PassTimer::stop() {
    mark();
    running_ = false;
    return std::move(times_);
}

void PassTimer::enter(const std::string& pass) {
    if (running_) {
        mark();
        stack_.push_back(pass);
    }
}

void PassTimer::leave() {
    if (running_ && !stack_.empty()) {
        mark();
        stack_.pop_back();
    }
}

void PassTimer::mark() {
    if (functions_->finish != nullptr) {
        functions_->finish();
    }
    const Clock::time_point now = Clock::now();
    timeOf(times_, stack_.empty() ? kOther : stack_.back()).ms +=
        std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
}

std::vector<PassTime> medianPasses(const std::vector<std::vector<PassTime>>& lists) {
    std::vector<PassTime> medians;
    for (const std::vector<PassTime>& list : lists) {
        for (const PassTime& time : list) {
            timeOf(medians, time.pass);
        }
    }
    for (PassTime& median : medians) {
        std::vector<double> values;
        for (std::vector<PassTime> list : lists) {
            values.push_back(timeOf(list, median.pass).ms);
        }
        median.ms = spreadOf(std::move(values)).median;
    }
    return medians;
}

} // namespace aolib::bench
