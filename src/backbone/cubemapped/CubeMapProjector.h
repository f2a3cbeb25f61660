#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <aolib/Statistics.h>

#include "backbone/Frame.h"
#include "gl/GLSLShader.h"
#include "gl/GpuTimer.h"
#include "gl/RenderToTexture2D.h"

namespace aolib {

inline constexpr int kFaces = 6;

/// A cube map that stands in the scene and projects its ambient occlusion onto it (thesis 4.4): six
/// faces side by side, 8 bits of visibility and 16 bits of distance per texel, nothing else.
class CubeMapProjector {
public:
    /// Errors: MissingCapability, OutOfMemory.
    static Result<CubeMapProjector> create(const gl::Functions& gl, CubeMapId id,
                                           const glm::vec3& position, int faceSize);

    CubeMapId id() const { return id_; }
    /// World units.
    const glm::vec3& position() const { return position_; }
    int faceSize() const { return faceSize_; }

    /// The distances that its code spans: nearest, log2(farthest / nearest).
    const glm::vec2& distanceCode() const { return distanceCode_; }
    void setDistanceCode(float nearest, float farthest);

    /// The kept texels: visibility, coded distance.
    const gl::RenderToTexture2D& texels() const { return texels_; }
    /// Another target of the same kind, for what is not kept yet. Errors: as create().
    static Result<gl::RenderToTexture2D> createTexels(const gl::Functions& gl, int faceSize,
                                                      const std::string& label);
    /// Binds what a projection reads and sets its uniforms.
    void bind(gl::GLSLShader& shader, int visibilityUnit, int distanceUnit) const;
    void bindDistance(gl::GLSLShader& shader, int unit) const;
    /// Reads everything back; waits for the GPU.
    CubeMapImage read(const gl::Functions& gl) const;

    CubeMapInfo info();

    /// The scene changed where this cube map sees it: build again before the next use.
    bool dirty = true;
    std::array<bool, kFaces> modelled{}; ///< faces that hold geometry
    int layers = 0;                      ///< solid intervals captured along a ray, at most
    std::size_t captureBytes = 0;        ///< GPU memory that the last build took and gave back
    double buildMs = 0.0;
    gl::GpuTimer timer;

private:
    CubeMapId id_{};
    glm::vec3 position_{};
    int faceSize_ = 0;
    glm::vec2 distanceCode_{1.0F, 1.0F};
    gl::RenderToTexture2D texels_;
};

/// World axes to a face's: right, up, forward.
glm::mat3 cubeToFace(int face);

} // namespace aolib
