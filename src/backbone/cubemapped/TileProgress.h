#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace aolib {

inline constexpr int kFaces = 6;

/// Which tiles of a cube map some view has asked for, and how far each has been computed, in passes
/// of whatever computes it. No GL.
class TileProgress {
public:
    static constexpr int kTile = 32;       ///< texels along a tile's edge
    static constexpr int kDetailScale = 4; ///< texels of detail along a texel

    struct Region {
        int face = 0;
        int x = 0; ///< lower left texel
        int y = 0;
        int width = 0; ///< texels; less than a tile's at a face's far edges
        int height = 0;
    };

    TileProgress() = default;
    explicit TileProgress(int faceSize);

    int faceSize() const { return faceSize_; }
    int count() const { return static_cast<int>(tiles_.size()); }
    Region region(int tile) const;

    /// Asks for the tile that a point of a face lies in, and for its neighbour where the point is
    /// near their border.
    /// @param at    texels
    /// @param fine  for detail, too, where the tile turns out to be rough. Faces smaller than a
    ///              tile's detail have none: it lies in layers of their size.
    void ask(int face, const glm::vec2& at, bool fine = false);
    void askAll();
    bool asked(int tile) const { return tiles_[static_cast<std::size_t>(tile)].asked; }

    int passes(int tile) const { return tiles_[static_cast<std::size_t>(tile)].passes; }
    void setPasses(int tile, int passes);
    /// Fewest passes of any tile that is asked for; -1 when none is.
    int fewestPasses() const;
    /// Whether some tile that is asked for has had fewer passes than this.
    bool lacks(int passes) const;
    /// The tiles that are asked for and have had the fewest passes, below `most`.
    std::vector<int> mostUrgent(int most) const;
    // ---- Detail: tiles that a view shows finer than their texels, and in which surfaces end.

    void setRough(int tile) { tiles_[static_cast<std::size_t>(tile)].rough = true; }
    bool needsDetail(int tile) const { return tiles_[static_cast<std::size_t>(tile)].detail(); }
    /// There is no room for a tile's detail: it needs none until allowDetail().
    void refuseDetail(int tile) { tiles_[static_cast<std::size_t>(tile)].refused = true; }
    bool refusedDetail() const;
    void allowDetail();
    int detailPasses(int tile) const { return tiles_[static_cast<std::size_t>(tile)].detailPasses; }
    void setDetailPasses(int tile, int passes);
    bool lacksDetail(int passes) const;

    /// Passes that what is asked for has had, and those that it needs when each needs so many.
    struct Share {
        std::int64_t done = 0;
        std::int64_t needed = 0;
    };
    Share share(int passes) const;

    /// Nothing is computed any more; what was asked for stays.
    void restart();

private:
    struct Tile {
        bool asked = false;
        bool fine = false;
        bool rough = false;
        bool refused = false;
        std::uint16_t passes = 0;
        std::uint16_t detailPasses = 0;
        bool detail() const { return fine && rough && !refused; }
    };
    int faceSize_ = 0;
    int perEdge_ = 0;
    std::vector<Tile> tiles_;
};

} // namespace aolib
