#include "backbone/texels/TileTurns.h"

#include <algorithm>
#include <utility>

namespace aolib {

namespace {

/// Of the rays that tiles which begin again take, so many more go to tiles that are to be refined:
/// what never rests leaves a third of the work to what does.
constexpr double kRefinedShare = 0.5;
/// Rays beyond which that debt does not grow: those of a few tiles.
constexpr double kMostOwed = 4e6;

} // namespace

bool TileTurns::has(const std::vector<Tile>& first) const {
    return std::ranges::all_of(first, [&](const Tile& tile) { return first_.contains(tile.key); });
}

std::vector<std::uint64_t> TileTurns::order(const std::vector<Tile>& first,
                                            const std::vector<Tile>& refined, std::size_t most) {
    const std::set<std::uint64_t> before = std::exchange(refined_, {});
    first_.clear();
    std::vector<std::uint64_t> keys;
    double owed = owed_;
    auto nextFirst = first.begin();
    auto nextRefined = refined.begin();
    while (keys.size() < most && (nextFirst != first.end() || nextRefined != refined.end())) {
        const bool begins = nextFirst != first.end();
        if (nextRefined != refined.end() && (!begins || owed >= nextRefined->rays)) {
            const Tile& tile = *nextRefined++;
            if (begins && before.contains(tile.key)) {
                continue;
            }
            owed -= tile.rays;
            refined_.insert(tile.key);
            keys.push_back(tile.key);
        } else {
            const Tile& tile = *nextFirst++;
            owed += tile.again ? kRefinedShare * tile.rays : 0.0;
            first_.insert(tile.key);
            keys.push_back(tile.key);
        }
    }
    return keys;
}

void TileTurns::answered(const Tile& tile, bool refined) {
    refined_.erase(tile.key);
    if (refined) {
        owed_ = std::max(owed_ - tile.rays, 0.0);
    } else if (tile.again) {
        owed_ = std::min(owed_ + kRefinedShare * tile.rays, kMostOwed);
    }
}

} // namespace aolib
