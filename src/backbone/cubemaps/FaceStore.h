#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "backbone/cubemaps/FreeList.h"
#include "backbone/cubemaps/TileTable.h"
#include "gl/GLSLShader.h"
#include "gl/TextureStack.h"

namespace aolib {

/// The texels that cube maps keep, 3 bytes each: a layer of 8-bit visibility and one of 16-bit
/// coded depth (shaders/shared/distance_code.h) for every face that holds geometry, none for the
/// others. All lie in two array textures, so that one pass reads them all. A layer may also hold
/// pages (PageStore).
class FaceStore {
public:
    explicit FaceStore(const gl::Functions& gl) : gl_(&gl) {}

    /// Drops all layers; those allocated from now on have this many texels along an edge.
    void reset(int faceSize);
    int faceSize() const { return faceSize_; }

    /// GPU memory of a layer of faces of this many texels along an edge, its pages included.
    static constexpr std::size_t bytesPerLayer(int faceSize) {
        const auto texels = static_cast<std::size_t>(faceSize);
        const auto tiles = static_cast<std::size_t>(tilesPerEdge(faceSize));
        return kBytesPerTexel * texels * texels + kBytesPerTile * tiles * tiles;
    }

    /// Limits the layers to this many, from the next allocation on.
    void setLimit(int layers) { limit_ = layers; }
    int limit() const { return limit_; }
    /// Layers that exist, whether allocated or free.
    int layers() const { return layers_.count(); }
    /// Sets the layers of a cube map aside, for allocateReserved() alone. They are not made yet.
    /// @return whether there was room.
    bool reserve();
    /// Ends a reservation, of which all layers were released.
    void unreserve() { reserved_ -= kFaces; }
    /// Layers that are neither set aside nor allocated.
    int freeLayers() const { return limit_ - reserved_ - unreserved_; }

    /// Allocates a layer in which nothing is known. May move all others in GPU memory.
    /// Errors: MissingCapability, OutOfMemory; then the store is as before.
    Result<int> allocate();
    void release(int layer);
    /// Allocates a layer of a reservation, for which there is room unless GL refuses.
    Result<int> allocateReserved();
    void releaseReserved(int layer);

    /// Binds a layer as target: visibility at location 0, depth at location 1.
    void bindAsTarget(int layer) const;
    /// Binds a layer's visibility (0) or depth (1) for reading.
    void bindForReading(int layer, int which) const;
    /// Replaces a rectangle of texels, row 0 at the bottom.
    void upload(int layer, const glm::ivec2& at, const glm::ivec2& size,
                std::span<const std::uint8_t> visibility,
                std::span<const std::uint16_t> depth) const;
    struct PageLocation {
        int layer;
        glm::ivec2 place; ///< column and row in the layer, in pages
    };
    /// Writes the page table's entry for a tile of a layer; none where the tile has no page.
    /// @param tile  column and row
    void setPage(int layer, const glm::ivec2& tile, const std::optional<PageLocation>& page) const;
    /// Makes the layers readable and sets uFaceSize.
    void bind(gl::GLSLShader& shader, int visibilityUnit, int depthUnit) const;
    /// Makes the pages readable.
    void bindPages(gl::GLSLShader& shader, int unit) const;

    std::size_t bytesPerFace() const {
        const auto texels = static_cast<std::size_t>(faceSize_);
        return kBytesPerTexel * texels * texels;
    }
    /// GPU memory, free layers included.
    std::size_t bytes() const;
    /// Whether there is a layer at all.
    bool empty() const { return layers_.empty(); }

private:
    static constexpr std::size_t kBytesPerTexel = 3; ///< R8 and R16
    static constexpr std::size_t kBytesPerTile = 4;  ///< RG16

    static constexpr int tilesPerEdge(int faceSize) {
        return (faceSize + TileTable::kTile - 1) / TileTable::kTile;
    }
    AoStatus grow();

    const gl::Functions* gl_;
    int faceSize_ = 0;
    gl::TextureStack visibility_;
    gl::TextureStack depth_;
    gl::TextureStack pageTable_; ///< per tile: 1 + layer and place of its page, or 0
    gl::Container framebuffer_;
    FreeList layers_;
    int limit_ = std::numeric_limits<int>::max();
    int reserved_ = 0;   ///< set aside, allocated or not
    int unreserved_ = 0; ///< allocated of the others
};

} // namespace aolib
