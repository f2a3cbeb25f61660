#pragma once

#include <utility>

#include <aolib/Status.h>

namespace aolib::bake {

/// Keeps what is made part by part, and the first error.
class MadeParts {
public:
    template <typename Place, typename Made>
    void keep(Place& place, Made made) {
        if (status_) {
            status_ = made.status();
        }
        if (made) {
            place = std::move(*made);
        }
    }
    const AoStatus& status() const { return status_; }

private:
    AoStatus status_;
};

} // namespace aolib::bake
