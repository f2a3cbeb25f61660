#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "backbone/cubemapped/Slots.h"
#include "backbone/cubemapped/TileProgress.h"
#include "gl/GLSLShader.h"
#include "gl/TextureStack.h"

namespace aolib {

/// The texels that cube maps keep, 3 bytes each: a layer of 8-bit visibility and one of 16-bit
/// coded depth (shaders/shared/distance_code.h) for every face that holds geometry, none for the
/// others. All lie in two array textures, so that one pass reads them all. A layer may also hold
/// blocks of finer texels (BlockStore), which a lookup then finds as cheaply.
class FaceStore {
public:
    explicit FaceStore(const gl::Functions& gl) : gl_(&gl) {}

    /// Forgets all layers; those taken from now on are faces of this many texels along an edge.
    void reset(int faceSize);
    int faceSize() const { return faceSize_; }

    /// GPU memory of a layer of faces of this many texels along an edge, its pages included.
    static constexpr std::size_t bytesPerLayer(int faceSize) {
        const auto texels = static_cast<std::size_t>(faceSize);
        const auto tiles = static_cast<std::size_t>(tilesPerEdge(faceSize));
        return kBytesPerTexel * texels * texels + kBytesPerTile * tiles * tiles;
    }

    /// At most this many layers, from the next one that is taken on.
    void setLimit(int layers) { limit_ = layers; }
    int limit() const { return limit_; }
    /// Layers that are allocated, whether taken or not.
    int layers() const { return slots_.count(); }
    /// Sets the layers of a cube map aside, for takeReserved() alone. They are not made yet.
    /// @return whether there was room.
    bool reserve();
    /// The cube map is gone, and has given back what it took.
    void release() { reserved_ -= kFaces; }
    /// Layers that are neither set aside nor taken.
    int spare() const { return limit_ - reserved_ - unreserved_; }

    /// A layer in which nothing is known. May move all others in GPU memory.
    /// Errors: MissingCapability, OutOfMemory; then the store is as before.
    Result<int> take();
    void giveBack(int layer);
    /// The same of what is set aside: such a layer is there, unless GL refuses.
    Result<int> takeReserved();
    void giveBackReserved(int layer);

    /// Directs rendering to a layer: visibility at location 0, depth at location 1.
    void begin(int layer) const;
    /// Directs reading to a layer's visibility (0) or depth (1).
    void beginRead(int layer, int which) const;
    /// Replaces a rectangle of texels, row 0 at the bottom.
    void upload(int layer, const glm::ivec2& at, const glm::ivec2& size,
                std::span<const std::uint8_t> visibility,
                std::span<const std::uint16_t> depth) const;
    /// A block of finer texels: the layer it lies in, and where, in blocks.
    struct Page {
        int layer;
        glm::ivec2 at;
    };
    /// Says which block a tile of a layer has beside its texels, if any. @param tile  column and
    /// row
    void setPage(int layer, const glm::ivec2& tile, const std::optional<Page>& page) const;
    /// Makes the layers readable and sets uFaceSize.
    void bind(gl::GLSLShader& shader, int visibilityUnit, int depthUnit) const;
    /// Makes the pages readable.
    void bindPages(gl::GLSLShader& shader, int unit) const;

    std::size_t bytesPerFace() const {
        const auto texels = static_cast<std::size_t>(faceSize_);
        return kBytesPerTexel * texels * texels;
    }
    /// GPU memory, layers in reserve included.
    std::size_t bytes() const;
    /// Whether there is a layer at all.
    bool empty() const { return slots_.empty(); }

private:
    static constexpr std::size_t kBytesPerTexel = 3; ///< R8 and R16
    static constexpr std::size_t kBytesPerTile = 4;  ///< RG16

    static constexpr int tilesPerEdge(int faceSize) {
        return (faceSize + TileProgress::kTile - 1) / TileProgress::kTile;
    }
    AoStatus grow();

    const gl::Functions* gl_;
    int faceSize_ = 0;
    gl::TextureStack visibility_;
    gl::TextureStack depth_;
    gl::TextureStack pages_; ///< per tile: 1 + layer and place of its block, or 0
    gl::Container framebuffer_;
    Slots slots_; ///< one per layer
    int limit_ = std::numeric_limits<int>::max();
    int reserved_ = 0;   ///< set aside, taken or not
    int unreserved_ = 0; ///< taken of the others
};

} // namespace aolib
