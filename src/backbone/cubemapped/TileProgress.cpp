#include "backbone/cubemapped/TileProgress.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>

namespace aolib {

namespace {

/// A point this near to a tile's border asks for the neighbour too, texels: views are sampled
/// sparsely, and lookups are bilinear.
constexpr float kNear = 8.0F;

} // namespace

TileProgress::TileProgress(int faceSize)
    : faceSize_(faceSize), perEdge_((faceSize + kTile - 1) / kTile),
      tiles_(static_cast<std::size_t>(kFaces * perEdge_ * perEdge_)) {}

TileProgress::Region TileProgress::region(int tile) const {
    const int perFace = perEdge_ * perEdge_;
    const int x = tile % perFace % perEdge_ * kTile;
    const int y = tile % perFace / perEdge_ * kTile;
    return {tile / perFace, x, y, std::min(kTile, faceSize_ - x), std::min(kTile, faceSize_ - y)};
}

int TileProgress::along(float texel) const {
    return std::clamp(static_cast<int>(texel) / kTile, 0, perEdge_ - 1);
}

int TileProgress::tileAt(int face, const glm::vec2& at) const {
    return (face * perEdge_ + along(at.y)) * perEdge_ + along(at.x);
}

std::vector<int> TileProgress::within(int face, const glm::vec2& low, const glm::vec2& high) const {
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

void TileProgress::ask(int face, const glm::vec2& at, int perBlock, AskedTiles* by) {
    if (by != nullptr) {
        by->resize(tiles_.size());
    }
    const int lastColumn = along(at.x + kNear);
    const int lastRow = along(at.y + kNear);
    const int firstColumn = along(at.x - kNear);
    for (int row = along(at.y - kNear); row <= lastRow; ++row) {
        for (int column = firstColumn; column <= lastColumn; ++column) {
            const auto number =
                static_cast<std::size_t>((face * perEdge_ + row) * perEdge_ + column);
            Tile& tile = tiles_[number];
            tile.asked = true;
            if (by != nullptr) {
                (*by)[number] = true;
            }
            if (perBlock > 0 && tile.blockPasses >= perBlock * tile.blocksAsked) {
                tile.blocksAsked = static_cast<std::uint8_t>(std::min(tile.blocksAsked + 1, 255));
            }
        }
    }
}

void TileProgress::setBlockPasses(int tile, int passes) {
    tiles_[static_cast<std::size_t>(tile)].blockPasses = static_cast<std::uint16_t>(passes);
}

bool TileProgress::lacksBlocks(int perBlock) const {
    return std::any_of(tiles_.begin(), tiles_.end(), [&](const Tile& tile) {
        return tile.blockPasses < perBlock * tile.blocksNeeded();
    });
}

bool TileProgress::refusedBlock() const {
    return std::any_of(tiles_.begin(), tiles_.end(), [](const Tile& tile) { return tile.refused; });
}

void TileProgress::allowBlocks() {
    for (Tile& tile : tiles_) {
        tile.refused = false;
    }
}

TileProgress::Share TileProgress::share(int passes, int blockWeight) const {
    Share share;
    for (const Tile& tile : tiles_) {
        if (tile.asked) {
            share.done += tile.passes;
            share.needed += passes;
        }
        const std::int64_t blocks = std::int64_t{blockWeight} * tile.blocksNeeded();
        share.needed += blocks * passes;
        share.done += std::min(std::int64_t{blockWeight} * tile.blockPasses, blocks * passes);
    }
    return share;
}

void TileProgress::askAll() {
    for (Tile& tile : tiles_) {
        tile.asked = true;
    }
}

void TileProgress::setPasses(int tile, int passes) {
    tiles_[static_cast<std::size_t>(tile)].passes = static_cast<std::uint16_t>(passes);
    if (passes > 0) {
        setKnown(tile);
    }
}

void TileProgress::setKnown(int tile) {
    Tile& of = tiles_[static_cast<std::size_t>(tile)];
    if (!of.known) {
        of.begunIn = frame_;
    }
    of.known = true;
}

bool TileProgress::allKnown() const {
    const auto asked = [](const Tile& tile) { return tile.asked; };
    return std::ranges::any_of(tiles_, asked) &&
           std::ranges::none_of(tiles_, [](const Tile& tile) { return tile.asked && !tile.known; });
}

int TileProgress::fewestPasses() const {
    int fewest = std::numeric_limits<int>::max();
    for (const Tile& tile : tiles_) {
        if (tile.asked) {
            fewest = std::min(fewest, static_cast<int>(tile.passes));
        }
    }
    return fewest == std::numeric_limits<int>::max() ? -1 : fewest;
}

bool TileProgress::lacks(int passes) const {
    const int fewest = fewestPasses();
    return fewest >= 0 && fewest < passes;
}

bool TileProgress::lacksUndisturbed(int passes) const {
    return std::ranges::any_of(tiles_, [&](const Tile& tile) {
        return tile.asked && !tile.disturbed && tile.passes < passes;
    });
}

bool TileProgress::lacksAny(const AskedTiles& tiles, int passes) const {
    for (std::size_t i = 0; i < std::min(tiles.size(), tiles_.size()); ++i) {
        const Tile& tile = tiles_[i];
        if (tiles[i] && (tile.passes < passes || tile.blockPasses < passes * tile.blocksNeeded())) {
            return true;
        }
    }
    return false;
}

std::vector<int> TileProgress::mostUrgent(int most) const {
    const int fewest = fewestPasses();
    std::vector<int> urgent;
    for (int tile = 0; fewest < most && tile < count(); ++tile) {
        if (asked(tile) && passes(tile) == fewest) {
            urgent.push_back(tile);
        }
    }
    return urgent;
}

void TileProgress::setAllOutdated() {
    for (Tile& tile : tiles_) {
        tile.outdated = true;
    }
}

void TileProgress::restart(int tile) {
    Tile& of = tiles_[static_cast<std::size_t>(tile)];
    of.outdated = false;
    of.disturbed = of.known;
    of.passes = 0;
    of.offered = 0;
    of.refused = false;
    of.blockPasses = 0;
}

void TileProgress::forget() {
    for (int tile = 0; tile < count(); ++tile) {
        tiles_[static_cast<std::size_t>(tile)].known = false;
        restart(tile);
    }
}

} // namespace aolib
