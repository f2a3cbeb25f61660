#pragma once

#include <functional>
#include <optional>
#include <string>

#include "FaultyLoader.h"
#include "HostTest.h"

namespace aolib {

/// What a call may answer when GL refuses this.
bool isSensible(Fault fault, StatusCode code);

/// A host whose GL refuses one thing after the other.
class RefusalTest : public HostTest {
protected:
    /// Which of a kind's calls are refused.
    struct Share {
        int stride = 1; ///< of so many calls one
        int first = 1;  ///< its number, 1 .. stride
    };

    void SetUp() override;
    void TearDown() override;

    /// All; or of AOLIB_FAULT_STRIDE calls one, from number AOLIB_FAULT_FIRST on: for tools that
    /// slow a run down a hundred times.
    static Share share();

    /// Calls with each use of this kind refused in turn, until one meets no refusal: each ends in
    /// a sensible status, the host's state intact and nothing left behind.
    /// @return how many uses there are (at most, by less than a stride), or the first that failed.
    int refuseEach(const std::string& name, Fault fault,
                   const std::function<AoStatus(const ProcAddressLoader&)>& call);

    std::optional<FaultyLoader> faulty_;
};

} // namespace aolib
