#pragma once

#include <cstdint>
#include <vector>

#include <aolib/Status.h>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "reference/VisibilityTracer.h"

namespace aolib {

/// The view that a picture is traced from, as a renderer would draw it.
struct PictureCamera {
    glm::dmat4 view{1.0};       ///< world to eye, looking along -z
    glm::dmat4 projection{1.0}; ///< eye to clip, depth -1 near to 1 far; perspective (infinite far
                                ///< plane included), off-centre or orthographic
    int width = 0;              ///< pixels, 1 to 65536
    int height = 0;             ///< pixels, 1 to 65536
};

/// Which normals the hemispheres are built about.
enum class NormalSource : std::uint8_t {
    Geometric, ///< of the triangle, turned towards the viewer
    Given,     ///< the mesh's, interpolated, turned to the seen side; geometric where it has none
};

struct PictureSettings {
    TraceSettings trace;
    NormalSource normals = NormalSource::Geometric;
    bool surfaces = false; ///< also fill depth, position, normal and triangle
};

/// A traced picture. Row 0 is the bottom row; index `y * width + x`.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<float> visibility;       ///< W; background -1
    std::vector<float> standardError;    ///< of each W; background -1
    std::vector<float> depth;            ///< along the viewing axis, world units; background -1
    std::vector<glm::vec3> position;     ///< world units; background 0
    std::vector<glm::vec3> normal;       ///< that W is about, unit length; background 0
    std::vector<std::uint32_t> triangle; ///< of the mesh; background 0
    double noise = 0.0;                  ///< expected RMSE of W from sampling, see VisibilityTracer
    bool complete = false; ///< false when cancelled; pixels not reached are background
};

/// Traces W at the centre of every pixel. What lies before the near or behind the far plane is not
/// seen, but still occludes.
/// Errors: InvalidCamera, InvalidOption.
Result<Picture> tracePicture(const RayScene& scene, const PictureCamera& camera,
                             const PictureSettings& settings, const LoopProgress& progress = {});

} // namespace aolib
