#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backbone/cubemapped/FaceStore.h"
#include "backbone/cubemapped/Slots.h"
#include "backbone/cubemapped/TileProgress.h"

namespace aolib {

/// What tiles keep beside their face's texels: blocks of one size in layers of the face store, as
/// many as there are such tiles. They hold finer texels of the same surfaces, or as fine ones of
/// the surfaces behind them.
class BlockStore {
public:
    /// The store of the layers must outlive it.
    explicit BlockStore(FaceStore& faces) : faces_(&faces) {}

    /// Texels of blocks along a texel of a face: 1 is of the surfaces behind. No block may be
    /// taken.
    void setScale(int scale) { scale_ = scale; }
    int scale() const { return scale_; }
    /// Whether faces are large enough for blocks, which lie in layers of their size.
    bool fits() const { return faces_->faceSize() >= edge(); }

    /// A block whose content is not defined. Errors: as FaceStore::take(); then all is as before.
    Result<int> take();
    void giveBack(int block);
    /// Replaces a block's texels, `width` of them along a row, row 0 at the bottom.
    void upload(int block, int width, int height, std::span<const std::uint8_t> visibility,
                std::span<const std::uint16_t> depth) const;
    /// Directs rendering to the layer that a block lies in: visibility at location 0, depth at
    /// location 1. @return the block's lower left texel there.
    glm::ivec2 begin(int block) const;
    /// Where a block lies.
    FaceStore::Page page(int block) const;
    bool empty() const { return slots_.empty(); }

private:
    int edge() const { return scale_ * TileProgress::kTile; } ///< of a block, texels
    int perRow() const { return faces_->faceSize() / edge(); }
    int perLayer() const { return perRow() * perRow(); }

    FaceStore* faces_;
    int scale_ = 1;
    std::vector<int> layers_; ///< of the face store
    Slots slots_;             ///< one per block, layer by layer
};

} // namespace aolib
