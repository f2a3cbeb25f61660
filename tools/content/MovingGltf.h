#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <vector>

#include <glm/mat4x4.hpp>

#include "content/GltfAnimation.h"
#include "content/GltfDocument.h"
#include "content/GltfSkin.h"
#include "content/LoadError.h"
#include "content/Model.h"

namespace aolib {

/// A model in a pose, and what has become of its directions.
struct PosedModel {
    Model model;
    /// By mesh: what takes vectors from the mesh at rest to the world, one for each vertex of a
    /// skin, else one for all.
    std::vector<std::vector<glm::mat3>> toWorld;

    /// A direction in the world as it is kept with a vertex, unit length: in the mesh's space at
    /// rest, to be transformed as the vertex's normal is.
    glm::vec3 atRest(std::size_t mesh, std::size_t vertex, const glm::vec3& direction) const;
};

/// A glTF in any pose of its animations: nodes that move, skins, morph targets.
class MovingGltf {
public:
    /// `file` as for readGltf().
    static Result<MovingGltf, LoadError> open(std::string_view bytes,
                                              const std::filesystem::path& file);

    std::size_t animations() const { return animations_.size(); }
    /// Seconds from 0 to the last key of an animation.
    double duration(std::size_t animation) const;
    /// The model at a time of an animation: meshes, vertices and triangles in the order of
    /// readGltf(). Meshes with a skin are in world space.
    Result<Model, LoadError> at(std::size_t animation, double seconds) const;
    Result<PosedModel, LoadError> posedAt(std::size_t animation, double seconds) const;
    /// What moves, as numbers: all properties that the animation has tracks for.
    std::vector<float> parameters(std::size_t animation, double seconds) const;

private:
    struct Pose;

    Result<glm::dmat4, LoadError> localTransform(const Pose& pose, std::size_t node) const;
    Result<std::vector<glm::mat4>, LoadError> worldTransforms(const Pose& pose) const;
    Result<ModelMesh, LoadError> posed(const ModelMesh& mesh, const Pose& pose,
                                       const std::vector<glm::mat4>& world,
                                       std::vector<glm::mat3>& toWorld) const;
    Result<bool, LoadError> morph(ModelMesh& mesh, const std::vector<double>& weights) const;
    Result<bool, LoadError> bend(ModelMesh& mesh, int skin, const std::vector<glm::mat4>& world,
                                 std::vector<glm::mat3>& toWorld) const;
    const tinygltf::Primitive& primitiveOf(const ModelMesh& mesh) const;

    GltfDocument document_;
    Model rest_;
    std::vector<GltfAnimation> animations_;
    std::vector<int> parents_; ///< by node, -1 at the top
};

} // namespace aolib
