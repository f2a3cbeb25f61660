#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backbone/cubemapped/FaceStore.h"
#include "backbone/cubemapped/Slots.h"
#include "backbone/cubemapped/TileProgress.h"

namespace aolib {

/// Texels of tiles that are kept finer than their face: blocks of one size in layers of the face
/// store, as many as there are such tiles.
class DetailStore {
public:
    static constexpr int kScale = TileProgress::kDetailScale;
    static constexpr int kBlock = kScale * TileProgress::kTile; ///< texels along a block's edge

    /// The store of the layers must outlive it.
    explicit DetailStore(FaceStore& faces) : faces_(&faces) {}

    /// A block whose content is not defined. Errors: as FaceStore::take(); then all is as before.
    Result<int> take();
    void giveBack(int block);
    /// Replaces a block's texels, `width` of them along a row, row 0 at the bottom.
    void upload(int block, int width, int height, std::span<const std::uint8_t> visibility,
                std::span<const std::uint16_t> depth) const;
    /// Where a block lies.
    FaceStore::Page page(int block) const;
    bool empty() const { return slots_.empty(); }

private:
    int perRow() const { return faces_->faceSize() / kBlock; }
    int perLayer() const { return perRow() * perRow(); }

    FaceStore* faces_;
    std::vector<int> layers_; ///< of the face store
    Slots slots_;             ///< one per block, layer by layer
};

} // namespace aolib
