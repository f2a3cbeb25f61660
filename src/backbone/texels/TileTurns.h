#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

namespace aolib {

/// Orders tiles for tracing: tiles without a pass come first. If a scene that changes in every
/// frame restarts such tiles again and again, the other tiles have their turns in between. No GL.
class TileTurns {
public:
    /// A tile with a pending pass.
    struct Tile {
        std::uint64_t key;
        double rays; ///< of the pass
        bool again;  ///< the tile already shows a result of an older scene
    };

    /// Whether all of these tiles were in the latest order().
    bool has(const std::vector<Tile>& first) const;
    /// The next tiles: keys, at most `most`.
    /// @param first    without a pass, the most urgent first
    /// @param refined  with some, likewise. One that was ordered before a tile without a pass, and
    ///                 has not been answered, may be under way: it waits for the next order.
    std::vector<std::uint64_t> order(const std::vector<Tile>& first,
                                     const std::vector<Tile>& refined, std::size_t most);
    /// Records a finished pass over a tile.
    void answered(const Tile& tile, bool refined);

private:
    std::set<std::uint64_t> first_;   ///< keys of the latest order
    std::set<std::uint64_t> refined_; ///< of the others in it, until they are answered
    double owed_ = 0.0; ///< rays that tiles which begin again took from those to be refined
};

} // namespace aolib
