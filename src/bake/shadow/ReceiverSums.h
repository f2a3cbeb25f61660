#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <aolib/Status.h>

#include "bake/geometry/BakeGeometry.h"
#include "bake/gpu/LightView.h"
#include "gl/GLSLShader.h"
#include "gl/RenderToTexture2D.h"
#include "gl/TextureStack.h"
#include "gl/VertexArray.h"

namespace aolib::bake {

/// A grid of receivers on the GPU, and the sums of what lights them. Needs known GL state in each
/// call.
class ReceiverSums {
public:
    ReceiverSums() = default;
    /// @param size  of the grid, texels. Errors: MissingCapability, OutOfMemory.
    static Result<ReceiverSums> create(const gl::Functions& gl, const glm::ivec2& size);

    /// Begins new sums.
    /// @param receivers  row by row; nothing where there is none.
    void begin(const BakeFrame& frame, std::span<const std::optional<SurfacePoint>> receivers);
    /// The box about the receivers; all zero where there are none.
    const FrameBox& box() const { return box_; }

    /// Adds what a fragment stage says of each receiver, which is bound and whose `uReceivers` is
    /// read from texture unit 0: layer 0 the position in the frame and 1, layer 1 the shading
    /// normal, 2 the triangle's own, on its side; all zero where there is none.
    void add(gl::GLSLShader& shader) const;

    /// Per receiver: weighed direction and weight.
    std::vector<glm::vec4> sums() const;

private:
    const gl::Functions* gl_ = nullptr;
    glm::ivec2 size_{0};
    FrameBox box_;
    gl::RenderToTexture2D sums_;
    gl::TextureStack receivers_;
    gl::VertexArray fullscreen_;
};

} // namespace aolib::bake
