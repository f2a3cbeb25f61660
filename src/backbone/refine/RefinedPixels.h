#pragma once

#include <cstddef>
#include <optional>

#include <glm/vec2.hpp>

#include "gl/TextureStack.h"

namespace aolib {

/// W of pixels of a view at rest, and the depth in the host's buffer that each was found for: one
/// layer, size of the frame.
class RefinedPixels {
public:
    /// Where nothing was found: no depth is negative.
    static constexpr glm::vec2 kNothing{1.0F, -1.0F};

    /// Makes room, with nothing found, unless there is. Errors: OutOfMemory.
    AoStatus makeRoom(const gl::Functions& gl, const glm::ivec2& size);
    /// Forgets all.
    void drop();
    /// Forgets those of a rectangle. @param size  pixels, may be 0 or below
    void drop(const glm::ivec2& low, const glm::ivec2& size);

    /// Null without room.
    const gl::TextureStack* texture() const { return texture_ ? &*texture_ : nullptr; }
    std::size_t bytes() const { return texture_ ? texture_->bytes() : 0; }

    std::size_t count = 0; ///< found so far

private:
    std::optional<gl::TextureStack> texture_;
};

} // namespace aolib
