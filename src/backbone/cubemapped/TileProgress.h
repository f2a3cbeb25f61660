#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace aolib {

inline constexpr int kFaces = 6;

/// Which tiles of a cube map one view has asked for, by their numbers; empty for none.
using AskedTiles = std::vector<bool>;

/// Which tiles of a cube map some view has asked for, and how far each has been computed, in passes
/// of whatever computes it. No GL.
class TileProgress {
public:
    static constexpr int kTile = 32; ///< texels along a tile's edge

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
    /// @param at        texels
    /// @param perBlock  passes that blocks need; where they are more than 0, for a block, too: the
    ///                  first, or one more than there are complete
    /// @param by        who asks notes the tiles here, if anywhere
    void ask(int face, const glm::vec2& at, int perBlock = 0, AskedTiles* by = nullptr);
    void askAll();
    /// The tile that a point of a face lies in. @param at  texels
    int tileAt(int face, const glm::vec2& at) const;
    /// The tiles of a face that a rectangle meets. @param low, high  its corners, texels
    std::vector<int> within(int face, const glm::vec2& low, const glm::vec2& high) const;
    bool asked(int tile) const { return tiles_[static_cast<std::size_t>(tile)].asked; }

    int passes(int tile) const { return tiles_[static_cast<std::size_t>(tile)].passes; }
    void setPasses(int tile, int passes);
    /// The frame in which passes are set from now on.
    void setFrame(std::uint64_t frame) { frame_ = frame; }
    /// Whether a tile has been known since before a frame.
    bool begunBefore(int tile, std::uint64_t frame) const {
        const Tile& of = tiles_[static_cast<std::size_t>(tile)];
        return of.known && of.begunIn <= frame;
    }
    /// Whether texels of a tile were written since it last lost all of them: it can be shown.
    bool known(int tile) const { return tiles_[static_cast<std::size_t>(tile)].known; }
    void setKnown(int tile);
    /// Whether some tile is asked for, and all of those are known.
    bool allKnown() const;
    /// Fewest passes of any tile that is asked for; -1 when none is.
    int fewestPasses() const;
    /// Whether some tile that is asked for has had fewer passes than this.
    bool lacks(int passes) const;
    /// The same of tiles that no change of the scene has made begin again.
    bool lacksUndisturbed(int passes) const;
    /// Whether some of these tiles has had fewer passes than this, or lacks some of its blocks.
    bool lacksAny(const AskedTiles& tiles, int passes) const;
    /// The tiles that are asked for and have had the fewest passes, below `most`.
    std::vector<int> mostUrgent(int most) const;
    // ---- Blocks: what a tile keeps beside its texels (BlockStore) where a view asks for it.

    /// So many blocks of a tile would tell what its texels do not.
    void offerBlocks(int tile, int count) {
        tiles_[static_cast<std::size_t>(tile)].offered = static_cast<std::uint8_t>(count);
    }
    /// Blocks that the tile is to have.
    int blocksNeeded(int tile) const {
        return tiles_[static_cast<std::size_t>(tile)].blocksNeeded();
    }
    /// There is no room for a tile's blocks: it needs none until allowBlocks().
    void refuseBlock(int tile) { tiles_[static_cast<std::size_t>(tile)].refused = true; }
    bool refusedBlock() const;
    void allowBlocks();
    /// Passes that a tile's blocks have had, one after the other.
    int blockPasses(int tile) const { return tiles_[static_cast<std::size_t>(tile)].blockPasses; }
    void setBlockPasses(int tile, int passes);
    bool lacksBlocks(int tile, int perBlock) const {
        return blockPasses(tile) < perBlock * blocksNeeded(tile);
    }
    bool lacksBlocks(int perBlock) const;

    /// Passes that what is asked for has had, and those that it needs when each needs so many: in
    /// passes over a tile, of which a block has `blockWeight` times as many texels.
    struct Share {
        std::int64_t done = 0;
        std::int64_t needed = 0;
    };
    Share share(int passes, int blockWeight) const;

    // ---- Changes of the scene: what a tile shows stays until it is replaced.

    /// The scene has changed for a tile: its passes are to begin again.
    void setOutdated(int tile) { tiles_[static_cast<std::size_t>(tile)].outdated = true; }
    bool outdated(int tile) const { return tiles_[static_cast<std::size_t>(tile)].outdated; }
    void setAllOutdated();
    /// No passes of a tile count any more; what was asked for, and what is known, stay.
    void restart(int tile);
    /// Nothing is known any more; what was asked for stays.
    void forget();

private:
    struct Tile {
        bool asked = false;
        bool refused = false;
        bool known = false;
        bool outdated = false;
        bool disturbed = false; ///< it began again while it was known
        std::uint8_t blocksAsked = 0;
        std::uint8_t offered = 0;
        std::uint16_t passes = 0;
        std::uint16_t blockPasses = 0;
        std::uint64_t begunIn = 0; ///< frame since which it is known
        int blocksNeeded() const { return refused ? 0 : std::min(blocksAsked, offered); }
    };
    /// Tiles before the one that a texel of an edge lies in.
    int along(float texel) const;

    int faceSize_ = 0;
    int perEdge_ = 0;
    std::uint64_t frame_ = 0;
    std::vector<Tile> tiles_;
};

} // namespace aolib
