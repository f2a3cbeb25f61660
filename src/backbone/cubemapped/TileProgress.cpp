#include "backbone/cubemapped/TileProgress.h"

#include <algorithm>
#include <limits>

namespace aolib {

namespace {

/// A point this near to a tile's border asks for the neighbour too, texels: views are sampled
/// sparsely, and lookups are bilinear.
constexpr float kNear = 8.0F;

/// Texels of detail per texel.
constexpr std::int64_t kDetailWeight = 16;

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

void TileProgress::ask(int face, const glm::vec2& at, bool fine) {
    const bool detail = fine && faceSize_ >= kDetailScale * kTile;
    const auto tileOf = [&](float texel) {
        return std::clamp(static_cast<int>(texel) / kTile, 0, perEdge_ - 1);
    };
    const int lastColumn = tileOf(at.x + kNear);
    const int lastRow = tileOf(at.y + kNear);
    const int firstColumn = tileOf(at.x - kNear);
    for (int row = tileOf(at.y - kNear); row <= lastRow; ++row) {
        for (int column = firstColumn; column <= lastColumn; ++column) {
            Tile& tile =
                tiles_[static_cast<std::size_t>((face * perEdge_ + row) * perEdge_ + column)];
            tile.asked = true;
            tile.fine = tile.fine || detail;
        }
    }
}

void TileProgress::setDetailPasses(int tile, int passes) {
    tiles_[static_cast<std::size_t>(tile)].detailPasses = static_cast<std::uint16_t>(passes);
}

bool TileProgress::lacksDetail(int passes) const {
    return std::any_of(tiles_.begin(), tiles_.end(), [&](const Tile& tile) {
        return tile.detail() && tile.detailPasses < passes;
    });
}

bool TileProgress::refusedDetail() const {
    return std::any_of(tiles_.begin(), tiles_.end(), [](const Tile& tile) { return tile.refused; });
}

void TileProgress::allowDetail() {
    for (Tile& tile : tiles_) {
        tile.refused = false;
    }
}

TileProgress::Share TileProgress::share(int passes) const {
    Share share;
    for (const Tile& tile : tiles_) {
        if (tile.asked) {
            share.done += tile.passes;
            share.needed += passes;
        }
        if (tile.detail()) { // so many more texels
            share.done += kDetailWeight * tile.detailPasses;
            share.needed += kDetailWeight * passes;
        }
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

void TileProgress::restart() {
    for (Tile& tile : tiles_) {
        tile.passes = 0;
        tile.rough = false;
        tile.refused = false;
        tile.detailPasses = 0;
    }
}

} // namespace aolib
