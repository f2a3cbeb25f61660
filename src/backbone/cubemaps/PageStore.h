#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backbone/cubemaps/FaceStore.h"
#include "backbone/cubemaps/FreeList.h"
#include "backbone/cubemaps/TileTable.h"
#include "backbone/estimators/Estimators.h"

namespace aolib {

/// Pages of tiles, all of one size, in layers of the face store: as many layers as there are pages.
class PageStore {
public:
    /// @param faces  outlives it.
    explicit PageStore(FaceStore& faces) : faces_(&faces) {}

    /// Sets what pages hold. No page may be allocated.
    void setKind(PageKind kind) { kind_ = kind; }
    PageKind kind() const { return kind_; }
    /// Texels of a page along a texel of its face.
    int scale() const { return kind_ == PageKind::Detail ? kDetailScale : 1; }
    /// Whether faces are large enough for pages, which lie in layers of their size.
    bool fits() const { return faces_->faceSize() >= edge(); }

    /// Allocates a page, whose content is not defined. Errors: as FaceStore::allocate(); then all
    /// is as before.
    Result<int> allocate();
    void release(int page);
    /// Replaces a page's texels, `width` of them along a row, row 0 at the bottom.
    void upload(int page, int width, int height, std::span<const std::uint8_t> visibility,
                std::span<const std::uint16_t> depth) const;
    /// Binds the layer that a page lies in as target: visibility at location 0, depth at
    /// location 1. @return the page's lower left texel there.
    glm::ivec2 bindAsTarget(int page) const;
    FaceStore::PageLocation location(int page) const;
    bool empty() const { return pages_.empty(); }

private:
    static constexpr int kDetailScale = 4;

    int edge() const { return scale() * TileTable::kTile; } ///< of a page, texels
    int perRow() const { return faces_->faceSize() / edge(); }
    int perLayer() const { return perRow() * perRow(); }

    FaceStore* faces_;
    PageKind kind_ = PageKind::HiddenLayer;
    std::vector<int> layers_; ///< of the face store
    FreeList pages_;          ///< layer by layer
};

} // namespace aolib
