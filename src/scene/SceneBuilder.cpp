#include "scene/SceneBuilder.h"

#include <string>
#include <utility>

#include "scene/Flatten.h"

namespace aolib {

AoStatus SceneBuilder::refuse(const char* call, const char* instead) const {
    return {StatusCode::InvalidCallOrder, std::string(call) + " is not allowed here: " + instead};
}

AoStatus SceneBuilder::fail(AoStatus status) {
    if (failure_.ok()) {
        failure_ = status;
    }
    return status;
}

AoStatus SceneBuilder::begin() {
    if (state_ != State::Idle) {
        return refuse("meshBegin", "a mesh has begun; call meshEnd first");
    }
    *this = SceneBuilder();
    state_ = State::Mesh;
    return {};
}

AoStatus SceneBuilder::normal(const glm::vec3& normal) {
    if (state_ != State::Mesh) {
        return refuse("aoNormal3f", "call it between meshBegin and aoBegin");
    }
    if (!positions_.empty() && !hasNormal_) {
        return refuse("aoNormal3f", "the mesh has vertices without a normal; set the first normal "
                                    "before the first vertex");
    }
    if (!isFinite(normal)) {
        return fail({StatusCode::InvalidNormal,
                     "normal of vertex " + std::to_string(positions_.size()) + " is not finite"});
    }
    currentNormal_ = normal;
    hasNormal_ = true;
    return {};
}

AoStatus SceneBuilder::vertex(const glm::vec3& position) {
    if (state_ != State::Mesh) {
        return refuse("aoVertex3f", "call it between meshBegin and aoBegin");
    }
    if (!isFinite(position)) {
        return fail({StatusCode::InvalidPosition,
                     "vertex " + std::to_string(positions_.size()) + " is not finite"});
    }
    positions_.push_back(position);
    if (hasNormal_) {
        normals_.push_back(currentNormal_);
    }
    return {};
}

AoStatus SceneBuilder::beginRun(AoPrimitive primitive) {
    if (state_ != State::Mesh) {
        return refuse("aoBegin", "call it between meshBegin and meshEnd, one run at a time");
    }
    if (primitive > AO_QUAD_STRIP) {
        return {StatusCode::InvalidPrimitive,
                std::to_string(static_cast<int>(primitive)) + " is not an AoPrimitive"};
    }
    primitive_ = primitive;
    run_.clear();
    state_ = State::Run;
    return {};
}

AoStatus SceneBuilder::index(std::uint32_t index) {
    if (state_ != State::Run) {
        return refuse("aoVertexIndex", "call it between aoBegin and aoEnd");
    }
    if (index >= positions_.size()) {
        return fail({StatusCode::InvalidIndex,
                     "index " + std::to_string(index) + " is out of range; the mesh has " +
                         std::to_string(positions_.size()) + " vertices so far"});
    }
    run_.push_back(index);
    return {};
}

AoStatus SceneBuilder::endRun() {
    if (state_ != State::Run) {
        return refuse("aoEnd", "call aoBegin first");
    }
    state_ = State::Mesh;
    if (AoStatus status = flatten(primitive_, run_, triangles_); !status) {
        return fail(std::move(status));
    }
    return {};
}

Result<Mesh> SceneBuilder::end() {
    if (state_ == State::Idle) {
        return refuse("meshEnd", "call meshBegin first");
    }
    if (state_ == State::Run) {
        return refuse("meshEnd", "a run of indices has begun; call aoEnd first");
    }
    const SceneBuilder done = std::exchange(*this, SceneBuilder());
    if (!done.failure_.ok()) {
        return done.failure_;
    }
    return makeMesh({done.positions_, done.normals_, done.triangles_, glm::mat4(1.0F)});
}

} // namespace aolib
