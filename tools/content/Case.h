#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

#include <aolib/Options.h>

#include "content/LoadError.h"
#include "content/Model.h"
#include "content/NamedCamera.h"

namespace aolib {

/// Which normals a case's receivers have.
enum class CaseNormals {
    Geometric, ///< those of the triangles
    Given,     ///< the model's own where it has any
};

/// One picture to compute: a scene, a camera and what ambient occlusion means in it. Every tool
/// reads it the same way. Lengths in world units.
struct Case {
    std::string mesh; ///< the name of a generated scene, or a file relative to `folder`
    glm::vec3 eye{0.0F};
    glm::vec3 target{0.0F, 0.0F, -1.0F};
    glm::vec3 up{0.0F, 1.0F, 0.0F};
    float fovyDeg = 45.0F; ///< vertical, degrees, in (0, 180)
    float near = 0.1F;     ///< > 0
    float far = 100.0F;    ///< > near
    int width = 960;       ///< pixels, 1 to 16384
    int height = 540;      ///< pixels, 1 to 16384
    float radius = 1.0F;   ///< > 0
    Falloff falloff = Falloff::Step;
    CaseNormals normals = CaseNormals::Geometric;
    std::optional<float> ground;  ///< y of a large horizontal quad added to the mesh
    std::filesystem::path folder; ///< of the case file; not written
};

/// Reads a case from JSON text. Unknown and missing keys, wrong types and values out of range are
/// errors that name the key. `file` names the case in messages and gives its folder.
Result<Case, LoadError> parseCase(std::string_view json, const std::filesystem::path& file);

/// The same from a file.
Result<Case, LoadError> readCase(const std::filesystem::path& file);

/// The case as JSON text; parseCase() gives it back unchanged.
std::string writeCase(const Case& scene);

/// The case's scene, with its ground as a mesh of its own named "ground" where it has one.
Result<Model, LoadError> loadCaseModel(const Case& scene);

/// Appends a horizontal quad at height y, 20 times as wide as the model is large, facing up.
void addGround(Model& model, float y);

/// The case's view.
NamedCamera caseCamera(const Case& scene);

} // namespace aolib
