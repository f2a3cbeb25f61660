#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "backbone/cubemapped/Slots.h"
#include "backbone/cubemapped/TileProgress.h"
#include "gl/GLSLShader.h"
#include "gl/TextureStack.h"

namespace aolib {

/// Texels of tiles that are kept finer than their face: blocks of one size in two array textures,
/// as many as there are such tiles.
class DetailStore {
public:
    static constexpr int kScale = 4; ///< texels of detail along a face's texel
    static constexpr int kBlock = kScale * TileProgress::kTile; ///< texels along a block's edge

    explicit DetailStore(const gl::Functions& gl) : gl_(&gl) {}

    /// A block whose content is not defined. Errors: MissingCapability, OutOfMemory; then the store
    /// is as before.
    Result<int> take();
    void giveBack(int block);
    /// Replaces a block's texels, `width` of them along a row, row 0 at the bottom.
    void upload(int block, int width, int height, std::span<const std::uint8_t> visibility,
                std::span<const std::uint16_t> depth) const;
    /// Makes the blocks readable.
    void bind(gl::GLSLShader& shader, int visibilityUnit, int depthUnit) const;
    bool empty() const { return slots_.empty(); }
    /// GPU memory, blocks in reserve included.
    std::size_t bytes() const;

private:
    static constexpr int kPerRow = 4; ///< blocks along a layer's edge
    static constexpr int kPerLayer = kPerRow * kPerRow;

    Status grow();

    const gl::Functions* gl_;
    gl::TextureStack visibility_;
    gl::TextureStack depth_;
    Slots slots_; ///< one per block
};

} // namespace aolib
