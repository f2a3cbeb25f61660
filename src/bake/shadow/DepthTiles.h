#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <aolib/Status.h>

#include "gl/GLSLShader.h"
#include "gl/RenderToTexture2D.h"

namespace aolib::bake {

/// Depth maps of one size, side by side in one texture. Needs known GL state in each
/// call.
class DepthTiles {
public:
    DepthTiles() = default;
    /// @param size  texels along a map. @param count  of maps; made less where no texture holds so
    /// many. Errors: ShaderError, MissingCapability, OutOfMemory.
    static Result<DepthTiles> create(const gl::Functions& gl, int size, int count);

    int size() const { return size_; }
    int count() const { return count_; }
    /// Maps beside each other in a row.
    int across() const { return across_; }
    /// The lowest texel of a map.
    glm::ivec2 origin(int number) const {
        return glm::ivec2(number % across_, number / across_) * size_;
    }
    /// Texels of the texture.
    glm::ivec2 texels() const { return {depths_.width(), depths_.height()}; }

    /// Makes ready for drawing. @param anew  all maps are emptied: nothing is nearer than 1.
    void begin(bool anew);
    /// From now on, until end(), what is drawn goes into this map.
    /// @return the program that draws.
    gl::GLSLShader& beginMap(int number, const glm::mat4& toClip);
    void end() const;

    void bind(int unit) const { depths_.bindDepthTexture(unit); }

private:
    const gl::Functions* gl_ = nullptr;
    int size_ = 0;
    int count_ = 0;
    int across_ = 1;
    gl::GLSLShader shader_;
    gl::RenderToTexture2D depths_;
};

} // namespace aolib::bake
