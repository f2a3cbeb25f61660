#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <aolib/Status.h>

#include "gl/GLSLShader.h"
#include "gl/RenderToTexture2D.h"
#include "host/LitMesh.h"
#include "scene/Bounds.h"

namespace aolib::host {

/// A depth map from a sun: the plainest of shadow maps, over the whole scene.
class SunDepth {
public:
    /// @param gl    must outlive it. @param size  texels along the map.
    /// Errors: ShaderError, MissingCapability, OutOfMemory.
    static Result<SunDepth> create(const gl::Functions& gl, int size);

    /// Draws it anew. @param direction  towards the sun, unit length.
    void draw(const std::vector<LitMesh>& meshes, const Bounds& bounds, const glm::vec3& direction);

    void bind(int unit) const { map_.bindDepthTexture(unit); }
    /// World to the map, 0 to 1 each way and in depth.
    const glm::mat4& worldToMap() const { return worldToMap_; }
    /// World units along a texel.
    float texel() const { return texel_; }

private:
    const gl::Functions* gl_ = nullptr;
    gl::GLSLShader shader_;
    gl::RenderToTexture2D map_;
    glm::mat4 worldToMap_{1.0F};
    float texel_ = 0.0F;
};

} // namespace aolib::host
