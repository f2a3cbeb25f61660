#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/Mesh.h"

namespace aolib {

/// The mesh between meshBegin() and meshEnd(): takes one vertex and one index at a time.
///
/// A call out of order is refused and changes nothing. Invalid data is refused and remembered:
/// since later indices would then name the wrong vertices, end() drops the mesh with that error.
class SceneBuilder {
public:
    AoStatus begin();
    AoStatus normal(const glm::vec3& normal);
    AoStatus vertex(const glm::vec3& position);
    AoStatus beginRun(AoPrimitive primitive);
    AoStatus index(std::uint32_t index);
    AoStatus endRun();
    Result<Mesh> end();

private:
    enum class State : std::uint8_t { Idle, Mesh, Run };

    AoStatus refuse(const char* call, const char* instead) const;
    AoStatus fail(AoStatus status);

    State state_ = State::Idle;
    std::vector<glm::vec3> positions_;
    std::vector<glm::vec3> normals_;
    std::vector<std::uint32_t> triangles_;
    std::vector<std::uint32_t> run_;
    AoPrimitive primitive_ = AO_TRIANGLES;
    glm::vec3 currentNormal_{};
    bool hasNormal_ = false;
    AoStatus failure_;
};

} // namespace aolib
