#pragma once

#include <utility>

#include <aolib/Status.h>

namespace aolib::bake {

/// The first error of several calls that create parts of an object.
class FirstError {
public:
    /// Assigns the value of `result` to `part`, or stores its error if none is stored yet.
    template <typename Part, typename PartResult>
    void assign(Part& part, PartResult result) {
        if (status_) {
            status_ = result.status();
        }
        if (result) {
            part = std::move(*result);
        }
    }
    const AoStatus& status() const { return status_; }

private:
    AoStatus status_;
};

} // namespace aolib::bake
