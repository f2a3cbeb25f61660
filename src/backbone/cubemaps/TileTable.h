#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace aolib {

inline constexpr int kFaces = 6;

/// Tiles of a cube map, true for those that one view requests; empty for none.
using TileSet = std::vector<bool>;

/// The tiles of a cube map: which of them some view requests, how many passes each has had, and the
/// pages that it has beside its texels (PageStore). No GL.
class TileTable {
public:
    static constexpr int kTile = 32; ///< texels along a tile's edge

    struct Region {
        int face = 0;
        int x = 0; ///< lower left texel
        int y = 0;
        int width = 0; ///< texels; fewer than kTile at a face's far edges
        int height = 0;
    };

    TileTable() = default;
    explicit TileTable(int faceSize);

    int faceSize() const { return faceSize_; }
    int count() const { return static_cast<int>(tiles_.size()); }
    Region region(int tile) const;
    /// The tile that a point of a face lies in. @param at  texels
    int tileAt(int face, const glm::vec2& at) const;
    /// The tiles of a face that a rectangle meets. @param low, high  its corners, texels
    std::vector<int> within(int face, const glm::vec2& low, const glm::vec2& high) const;

    // ---- Requests

    /// Requests the tile that a point of a face lies in, and its neighbour where the point is near
    /// their border.
    /// @param at             texels
    /// @param passesPerPage  above 0 to request a page, too: the first, or one more than there are
    ///                       complete
    /// @param requested      set of the view, to which the tiles are added; may be null
    void request(int face, const glm::vec2& at, int passesPerPage = 0,
                 TileSet* requested = nullptr);
    void requestAll();
    bool isRequested(int tile) const { return entry(tile).requested; }

    // ---- Passes of a tile's texels

    int passes(int tile) const { return entry(tile).passes; }
    void setPasses(int tile, int passes);
    /// Sets the number of the frame in which passes are set from now on.
    void setFrame(std::uint64_t frame) { frame_ = frame; }
    /// Whether texels of a tile were written since it last lost all of them: it can be shown.
    bool isKnown(int tile) const { return entry(tile).known; }
    void setKnown(int tile);
    /// Whether a tile has been known since a frame or longer.
    bool isKnownSince(int tile, std::uint64_t frame) const {
        return entry(tile).known && entry(tile).knownSince <= frame;
    }
    /// Whether some tile is requested, and all of those are known.
    bool allKnown() const;
    /// Fewest passes of any requested tile; -1 when none is.
    int fewestPasses() const;
    /// Whether some requested tile has had fewer passes than this.
    bool hasPending(int passes) const;
    /// Whether some of these was never restarted by a change of the scene.
    bool hasPendingUndisturbed(int passes) const;
    /// Whether some tile of a set has had fewer passes than this, or is without some of its pages.
    bool hasPendingIn(const TileSet& tiles, int passes) const;
    /// The requested tiles that have had the fewest passes, below `most`.
    std::vector<int> mostUrgent(int most) const;

    // ---- Pages

    /// Sets the number of pages that hold more than a tile's texels.
    void setAvailablePages(int tile, int count) {
        entry(tile).available = static_cast<std::uint8_t>(count);
    }
    /// Pages that the tile is to have.
    int pagesNeeded(int tile) const { return entry(tile).pagesNeeded(); }
    /// Denies a tile its pages, for which there is no room, until clearDeniedPages().
    void denyPages(int tile) { entry(tile).denied = true; }
    bool hasDeniedPages() const;
    void clearDeniedPages();
    /// Passes that a tile's pages have had, one page after the other.
    int pagePasses(int tile) const { return entry(tile).pagePasses; }
    void setPagePasses(int tile, int passes);
    bool hasPendingPages(int tile, int passesPerPage) const {
        return pagePasses(tile) < passesPerPage * pagesNeeded(tile);
    }
    bool hasPendingPages(int passesPerPage) const;

    /// Passes that requested tiles have had and need, where each needs `passes`. A pass over a page
    /// counts `pageWeight` times.
    struct Share {
        std::int64_t done = 0;
        std::int64_t needed = 0;
    };
    Share share(int passes, int pageWeight) const;

    // ---- Changes of the scene: what a tile shows stays until it is replaced

    /// Marks a tile whose passes are to begin again, for the scene has changed.
    void setOutdated(int tile);
    void setAllOutdated();
    bool isOutdated(int tile) const { return entry(tile).outdated; }
    bool hasOutdated() const { return outdated_ > 0; }
    /// Restarts a tile's passes. Requests and shown texels stay.
    void restart(int tile);
    /// Restarts all tiles and drops their texels. Requests stay.
    void forget();

private:
    struct Tile {
        bool requested = false;
        bool denied = false;
        bool known = false;
        bool outdated = false;
        bool disturbed = false; ///< it was restarted while it was known
        std::uint8_t pagesRequested = 0;
        std::uint8_t available = 0;
        std::uint16_t passes = 0;
        std::uint16_t pagePasses = 0;
        std::uint64_t knownSince = 0; ///< number of a frame
        int pagesNeeded() const { return denied ? 0 : std::min(pagesRequested, available); }
    };
    Tile& entry(int tile) { return tiles_[static_cast<std::size_t>(tile)]; }
    const Tile& entry(int tile) const { return tiles_[static_cast<std::size_t>(tile)]; }
    /// Tiles before the one that a texel of an edge lies in.
    int along(float texel) const;

    int faceSize_ = 0;
    int perEdge_ = 0;
    int outdated_ = 0; ///< tiles that are
    std::uint64_t frame_ = 0;
    std::vector<Tile> tiles_;
};

} // namespace aolib
