#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "bake/gpu/BakeVertices.h"
#include "bake/gpu/Slabs.h"

namespace aolib::bake {

/// Which triangles lie in which of a direction's slabs: one that crosses a border lies in several.
class SlabBins {
public:
    /// Both must outlive it. @param indices  three per triangle.
    SlabBins(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices)
        : positions_(positions), corners_(indices) {}

    /// From now on bins are those of these slabs, and empty.
    void begin(const Slabs& slabs);
    /// Fills the bins of slabs `first` to `last` - 1, and empties the others.
    void fill(int first, int last);

    /// Of the last filling: what a bin holds in numbers() and, three at a time, in indices().
    TriangleRange bin(int slab) const;
    const std::vector<std::uint32_t>& numbers() const { return numbers_; }
    const std::vector<std::uint32_t>& indices() const { return indices_; }

private:
    /// Slabs that a triangle lies in.
    struct Span {
        std::int32_t low = 0;
        std::int32_t high = 0;
    };

    std::span<const glm::vec3> positions_;
    std::span<const std::uint32_t> corners_;
    std::vector<float> coordinates_; ///< per position
    std::vector<Span> spans_;        ///< per triangle
    int first_ = 0;
    std::vector<std::size_t> starts_; ///< of the bins that are filled, and where the last one ends
    std::vector<std::uint32_t> numbers_;
    std::vector<std::uint32_t> indices_;
};

} // namespace aolib::bake
