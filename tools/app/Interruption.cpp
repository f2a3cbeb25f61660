#include "app/Interruption.h"

#include <atomic>
#include <csignal>

namespace aolib::app {

namespace {

std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

extern "C" void rememberInterruption(int signal) {
    interrupted = true;
    std::signal(signal, SIG_DFL);
}

} // namespace

Interruption::Interruption() {
    interrupted = false;
    std::signal(SIGINT, rememberInterruption);
    std::signal(SIGTERM, rememberInterruption);
}

Interruption::~Interruption() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool Interruption::happened() {
    return interrupted;
}

} // namespace aolib::app
