#pragma once

#include <optional>
#include <string>

#include "GLTest.h"
#include "HostState.h"
#include "Poison.h"

namespace aolib {

/// A test that plays a host: its objects, the states that it may be in, and what it sees of them.
class HostTest : public GLTest {
protected:
    void SetUp() override;
    void TearDown() override;
    /// @param newest  else a host that knows nothing beyond GL 3.3.
    void setUpHost(bool newest);

    /// Random states per context: the test's own number, or that of AOLIB_STATE_SEEDS.
    static unsigned seeds(unsigned usual);
    /// What aoDrawEnd() must answer to a host in this state.
    StatusCode frameStatus(const HostView& view) const;
    /// What aoApply() must answer.
    static StatusCode applyStatus(const HostView& view);

    std::optional<HostGl> host;
    std::optional<HostObjects> objects;
    std::optional<Poison> poison;
    std::optional<HostState> state;
};

} // namespace aolib
