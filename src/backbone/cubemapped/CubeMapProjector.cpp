#include "backbone/cubemapped/CubeMapProjector.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/matrix.hpp>

#include "shared/cube_faces.h"
#include "shared/distance_code.h"

namespace aolib {

glm::mat3 cubeToFace(int face) {
    return glm::transpose(
        glm::mat3(shared::faceRight(face), shared::faceUp(face), shared::faceForward(face)));
}

Result<gl::RenderToTexture2D> CubeMapProjector::createTexels(const gl::Functions& gl, int faceSize,
                                                             const std::string& label) {
    using Format = gl::RenderToTexture2D::Format;
    return gl::RenderToTexture2D::create(gl, {.width = kFaces * faceSize,
                                              .height = faceSize,
                                              .targets = {Format::R8, Format::R16},
                                              .label = label});
}

Result<CubeMapProjector> CubeMapProjector::create(const gl::Functions& gl, CubeMapId id,
                                                  const glm::vec3& position, int faceSize) {
    auto texels =
        createTexels(gl, faceSize, "aolib/cube" + std::to_string(static_cast<std::uint32_t>(id)));
    if (!texels) {
        return texels.status();
    }
    auto timer = gl::GpuTimer::create(gl);
    if (!timer) {
        return timer.status();
    }
    CubeMapProjector projector;
    projector.id_ = id;
    projector.position_ = position;
    projector.faceSize_ = faceSize;
    projector.texels_ = std::move(*texels);
    projector.timer = std::move(*timer);
    return projector;
}

void CubeMapProjector::setDistanceCode(float nearest, float farthest) {
    distanceCode_ = {nearest, std::log2(farthest / nearest)};
}

void CubeMapProjector::bindDistance(gl::GLSLShader& shader, int unit) const {
    texels_.bindTexture(1, unit);
    shader.set("uCubeDistance", unit);
    shader.set("uFaceSize", faceSize_);
    shader.set("uDistanceCode", distanceCode_);
}

void CubeMapProjector::bind(gl::GLSLShader& shader, int visibilityUnit, int distanceUnit) const {
    texels_.bindTexture(0, visibilityUnit);
    shader.set("uCubeVisibility", visibilityUnit);
    bindDistance(shader, distanceUnit);
}

CubeMapImage CubeMapProjector::read(const gl::Functions& gl) const {
    const auto count = static_cast<std::size_t>(kFaces * faceSize_ * faceSize_);
    CubeMapImage image{faceSize_, position_, std::vector<float>(count), std::vector<float>(count)};
    texels_.beginRead(0);
    gl.ReadPixels(0, 0, kFaces * faceSize_, faceSize_, GL_RED, GL_FLOAT, image.visibility.data());
    texels_.beginRead(1);
    gl.ReadPixels(0, 0, kFaces * faceSize_, faceSize_, GL_RED, GL_FLOAT, image.distance.data());
    for (float& distance : image.distance) {
        distance = distance > 0.0F
                       ? shared::decodeDistance(distance, distanceCode_.x, distanceCode_.y)
                       : -1.0F;
    }
    return image;
}

CubeMapInfo CubeMapProjector::info() {
    return {.id = id_,
            .position = position_,
            .faceSize = faceSize_,
            .facesModelled = static_cast<int>(std::count(modelled.begin(), modelled.end(), true)),
            .layers = layers,
            .bytes = texels_.bytes(),
            .captureBytes = captureBytes,
            .buildMs = buildMs,
            .buildGpuMs = timer.milliseconds()};
}

} // namespace aolib
