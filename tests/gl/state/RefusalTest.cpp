#include "RefusalTest.h"

#include <algorithm>
#include <cstdlib>

namespace aolib {

namespace {

/// A whole number above 0; 1 if there is none.
int numberFrom(const char* variable) {
    const char* text = std::getenv(variable);
    return text == nullptr ? 1 : std::max(1, std::atoi(text));
}

} // namespace

bool isSensible(Fault fault, StatusCode code) {
    switch (fault) {
    case Fault::CompileShader:
    case Fault::LinkProgram:
        return code == StatusCode::ShaderError;
    case Fault::FramebufferStatus:
        return code == StatusCode::MissingCapability || code == StatusCode::InvalidFramebuffer;
    case Fault::FenceSync:
    case Fault::MapBuffer:
        return false; // coverage is unknown for longer, that is all
    default:
        return code == StatusCode::OutOfMemory;
    }
}

void RefusalTest::SetUp() {
    HostTest::SetUp();
    if (!IsSkipped() && !HasFatalFailure()) {
        faulty_.emplace(loader);
    }
}

void RefusalTest::TearDown() {
    faulty_.reset();
    HostTest::TearDown();
}

RefusalTest::Share RefusalTest::share() {
    const int stride = numberFrom("AOLIB_FAULT_STRIDE");
    return {stride, std::min(stride, numberFrom("AOLIB_FAULT_FIRST"))};
}

int RefusalTest::refuseEach(const std::string& name, Fault fault,
                            const std::function<AoStatus(const ProcAddressLoader&)>& call) {
    const Share part = share();
    int n = part.first;
    for (;; n += part.stride) {
        const std::string where = name + ", " + faultName(fault) + " " + std::to_string(n);
        Dice dice(static_cast<unsigned>(n));
        poison->apply(dice, HostView{});
        const HostState::Snapshot clean = state->snapshot();
        faulty_->failAt(fault, n);
        const AoStatus status = call(faulty_->loader());
        EXPECT_EQ(state->difference(clean, state->snapshot()), "") << where;
        EXPECT_EQ(faulty_->alive(), "") << where;
        if (!faulty_->failed()) {
            EXPECT_TRUE(status.ok()) << where << ": " << status.message();
            break;
        }
        EXPECT_TRUE(isSensible(fault, status.code()))
            << where << ": " << statusName(status.code()) << ", " << status.message();
        if (HasFailure()) {
            return n;
        }
    }
    faulty_->heal();
    return n - 1;
}

} // namespace aolib
