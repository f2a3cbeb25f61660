#include "bake/gpu/SlabTriangles.h"

#include <utility>
#include <vector>

namespace aolib::bake {

AoStatus SlabTriangles::prepare(int first, int last) {
    bins_.fill(first, last);
    const std::vector<std::uint32_t>& indices = bins_.indices();
    if (indices.empty()) {
        return {};
    }
    Result<gl::Buffer> buffer =
        gl::Buffer::create(*gl_, GL_ARRAY_BUFFER, indices.size() * sizeof(std::uint32_t),
                           indices.data(), GL_STREAM_DRAW, "aolib/bake/slabs");
    if (!buffer) {
        return buffer.status();
    }
    indices_ = std::move(*buffer);
    return {};
}

void SlabTriangles::draw(gl::GLSLShader& shader, int slab) const {
    vertices_->drawNumbered(shader, indices_, bins_.bin(slab));
}

std::span<const std::uint32_t> SlabTriangles::numbers(int slab) const {
    const TriangleRange range = bins_.bin(slab);
    return std::span(bins_.numbers()).subspan(range.first, range.count);
}

} // namespace aolib::bake
