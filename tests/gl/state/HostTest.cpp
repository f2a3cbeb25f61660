#include "HostTest.h"

#include <cstdlib>

namespace aolib {

void HostTest::SetUp() {
    GLTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) {
        return;
    }
    setUpHost(true);
}

void HostTest::setUpHost(bool newest) {
    state.reset();
    poison.reset();
    objects.reset();
    host.emplace(HostGl::load(loader, newest));
    objects.emplace(*host);
    poison.emplace(*host, *objects);
    state.emplace(*host, *objects);
    poison->calm();
}

void HostTest::TearDown() {
    if (poison) {
        poison->calm();
        EXPECT_EQ(objects->damage(), "") << "the host's objects were written to";
        state.reset();
        poison.reset();
        objects.reset();
    }
    GLTest::TearDown();
}

unsigned HostTest::seeds(unsigned usual) {
    const char* text = std::getenv("AOLIB_STATE_SEEDS");
    return text != nullptr ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : usual;
}

StatusCode HostTest::applyStatus(const HostView& view) {
    return view.depthRange[0] != view.depthRange[1] ? StatusCode::Ok
                                                    : StatusCode::InvalidFramebuffer;
}

StatusCode HostTest::frameStatus(const HostView& view) const {
    const bool seen =
        view.viewport[2] > 0 && view.viewport[3] > 0 && view.depthRange[0] != view.depthRange[1];
    return seen && objects->usable(view.target) ? StatusCode::Ok : StatusCode::InvalidFramebuffer;
}

} // namespace aolib
