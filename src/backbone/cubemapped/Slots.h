#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace aolib {

/// Which of a store's places are taken.
class Slots {
public:
    int count() const { return static_cast<int>(taken_.size()); }
    bool empty() const { return taken_.empty(); }
    /// Adds free places up to a count.
    void growTo(int count) { taken_.resize(static_cast<std::size_t>(count), false); }
    void clear() { taken_.clear(); }

    /// Takes the first free place; nothing when all are taken.
    std::optional<int> take() {
        const auto free = std::find(taken_.begin(), taken_.end(), false);
        if (free == taken_.end()) {
            return std::nullopt;
        }
        *free = true;
        return static_cast<int>(free - taken_.begin());
    }
    /// @return whether no place is taken any more.
    bool giveBack(int slot) {
        taken_.at(static_cast<std::size_t>(slot)) = false;
        return std::find(taken_.begin(), taken_.end(), true) == taken_.end();
    }

private:
    std::vector<bool> taken_;
};

} // namespace aolib
