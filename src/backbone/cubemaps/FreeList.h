#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace aolib {

/// Which numbers of a range are allocated.
class FreeList {
public:
    int count() const { return static_cast<int>(allocated_.size()); }
    bool empty() const { return allocated_.empty(); }
    /// Extends the range by free numbers up to a count.
    void growTo(int count) { allocated_.resize(static_cast<std::size_t>(count), false); }
    void clear() { allocated_.clear(); }

    /// Allocates the lowest free number; none where all are allocated.
    std::optional<int> allocate() {
        const auto free = std::find(allocated_.begin(), allocated_.end(), false);
        if (free == allocated_.end()) {
            return std::nullopt;
        }
        *free = true;
        return static_cast<int>(free - allocated_.begin());
    }
    /// Frees a number. @return whether all are free now.
    bool release(int number) {
        allocated_.at(static_cast<std::size_t>(number)) = false;
        return std::find(allocated_.begin(), allocated_.end(), true) == allocated_.end();
    }

private:
    std::vector<bool> allocated_;
};

} // namespace aolib
