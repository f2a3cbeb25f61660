#include "backbone/cubemaps/TileTable.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>

namespace aolib {

namespace {

/// A point this near to a tile's border requests the neighbour too, texels: views are sampled
/// sparsely, and lookups are bilinear.
constexpr float kNear = 8.0F;

} // namespace

TileTable::TileTable(int faceSize)
    : faceSize_(faceSize), perEdge_((faceSize + kTile - 1) / kTile),
      tiles_(static_cast<std::size_t>(kFaces * perEdge_ * perEdge_)) {}

TileTable::Region TileTable::region(int tile) const {
    const int perFace = perEdge_ * perEdge_;
    const int x = tile % perFace % perEdge_ * kTile;
    const int y = tile % perFace / perEdge_ * kTile;
    return {tile / perFace, x, y, std::min(kTile, faceSize_ - x), std::min(kTile, faceSize_ - y)};
}

int TileTable::along(float texel) const {
    return std::clamp(static_cast<int>(texel) / kTile, 0, perEdge_ - 1);
}

int TileTable::tileAt(int face, const glm::vec2& at) const {
    return (face * perEdge_ + along(at.y)) * perEdge_ + along(at.x);
}

std::vector<int> TileTable::within(int face, const glm::vec2& low, const glm::vec2& high) const {
    const auto size = static_cast<float>(faceSize_);
    std::vector<int> found;
    if (low.x > size || low.y > size || high.x < 0.0F || high.y < 0.0F) {
        return found;
    }
    const int first = tileAt(face, glm::max(low, 0.0F));
    const int last = tileAt(face, glm::min(high, size));
    for (int row = first / perEdge_; row <= last / perEdge_; ++row) {
        for (int column = first % perEdge_; column <= last % perEdge_; ++column) {
            found.push_back(row * perEdge_ + column);
        }
    }
    return found;
}

void TileTable::request(int face, const glm::vec2& at, int passesPerPage, TileSet* requested) {
    if (requested != nullptr) {
        requested->resize(tiles_.size());
    }
    const int lastColumn = along(at.x + kNear);
    const int lastRow = along(at.y + kNear);
    const int firstColumn = along(at.x - kNear);
    for (int row = along(at.y - kNear); row <= lastRow; ++row) {
        for (int column = firstColumn; column <= lastColumn; ++column) {
            const auto number =
                static_cast<std::size_t>((face * perEdge_ + row) * perEdge_ + column);
            Tile& tile = tiles_[number];
            tile.requested = true;
            if (requested != nullptr) {
                (*requested)[number] = true;
            }
            if (passesPerPage > 0 && tile.pagePasses >= passesPerPage * tile.pagesRequested) {
                tile.pagesRequested =
                    static_cast<std::uint8_t>(std::min(tile.pagesRequested + 1, 255));
            }
        }
    }
}

void TileTable::setPagePasses(int tile, int passes) {
    entry(tile).pagePasses = static_cast<std::uint16_t>(passes);
}

bool TileTable::hasPendingPages(int passesPerPage) const {
    return std::any_of(tiles_.begin(), tiles_.end(), [&](const Tile& tile) {
        return tile.pagePasses < passesPerPage * tile.pagesNeeded();
    });
}

bool TileTable::hasDeniedPages() const {
    return std::any_of(tiles_.begin(), tiles_.end(), [](const Tile& tile) { return tile.denied; });
}

void TileTable::clearDeniedPages() {
    for (Tile& tile : tiles_) {
        tile.denied = false;
    }
}

TileTable::Share TileTable::share(int passes, int pageWeight) const {
    Share share;
    for (const Tile& tile : tiles_) {
        if (tile.requested) {
            share.done += tile.passes;
            share.needed += passes;
        }
        const std::int64_t pages = std::int64_t{pageWeight} * tile.pagesNeeded();
        share.needed += pages * passes;
        share.done += std::min(std::int64_t{pageWeight} * tile.pagePasses, pages * passes);
    }
    return share;
}

void TileTable::requestAll() {
    for (Tile& tile : tiles_) {
        tile.requested = true;
    }
}

void TileTable::setPasses(int tile, int passes) {
    entry(tile).passes = static_cast<std::uint16_t>(passes);
    if (passes > 0) {
        setKnown(tile);
    }
}

void TileTable::setKnown(int tile) {
    Tile& of = entry(tile);
    if (!of.known) {
        of.knownSince = frame_;
    }
    of.known = true;
}

bool TileTable::allKnown() const {
    const auto requested = [](const Tile& tile) { return tile.requested; };
    return std::ranges::any_of(tiles_, requested) &&
           std::ranges::none_of(tiles_,
                                [](const Tile& tile) { return tile.requested && !tile.known; });
}

int TileTable::fewestPasses() const {
    int fewest = std::numeric_limits<int>::max();
    for (const Tile& tile : tiles_) {
        if (tile.requested) {
            fewest = std::min(fewest, static_cast<int>(tile.passes));
        }
    }
    return fewest == std::numeric_limits<int>::max() ? -1 : fewest;
}

bool TileTable::hasPending(int passes) const {
    const int fewest = fewestPasses();
    return fewest >= 0 && fewest < passes;
}

bool TileTable::hasPendingUndisturbed(int passes) const {
    return std::ranges::any_of(tiles_, [&](const Tile& tile) {
        return tile.requested && !tile.disturbed && tile.passes < passes;
    });
}

bool TileTable::hasPendingIn(const TileSet& tiles, int passes) const {
    for (std::size_t i = 0; i < std::min(tiles.size(), tiles_.size()); ++i) {
        const Tile& tile = tiles_[i];
        if (tiles[i] && (tile.passes < passes || tile.pagePasses < passes * tile.pagesNeeded())) {
            return true;
        }
    }
    return false;
}

std::vector<int> TileTable::mostUrgent(int most) const {
    const int fewest = fewestPasses();
    std::vector<int> urgent;
    for (int tile = 0; fewest < most && tile < count(); ++tile) {
        if (isRequested(tile) && passes(tile) == fewest) {
            urgent.push_back(tile);
        }
    }
    return urgent;
}

void TileTable::setOutdated(int tile) {
    outdated_ += entry(tile).outdated ? 0 : 1;
    entry(tile).outdated = true;
}

void TileTable::setAllOutdated() {
    for (Tile& tile : tiles_) {
        tile.outdated = true;
    }
    outdated_ = count();
}

void TileTable::restart(int tile) {
    Tile& of = entry(tile);
    outdated_ -= of.outdated ? 1 : 0;
    of.outdated = false;
    of.disturbed = of.known;
    of.passes = 0;
    of.available = 0;
    of.denied = false;
    of.pagePasses = 0;
}

void TileTable::forget() {
    for (int tile = 0; tile < count(); ++tile) {
        entry(tile).known = false;
        restart(tile);
    }
}

} // namespace aolib
