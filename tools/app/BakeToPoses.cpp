#include "app/BakeToPoses.h"

#include <string>
#include <utility>

#include "app/BakeToVertices.h"
#include "app/Table.h"

namespace aolib::app {

MaybeFailure BakeToPoses::prepare(OutputFiles& /*files*/) {
    if (flags_.target != BakeTarget::Vertex || flags_.attribute != VertexAttribute::Ao ||
        !flags_.ao.empty() || !flags_.bentNormals.empty() || flags_.out.empty()) {
        return badInput("--poses goes with --target vertex and -o, and writes attributes _AO_0, "
                        "_BENT_NORMAL_0, _AO_1, ... alone");
    }
    Result<MovingGltf, LoadError> moving = MovingGltf::open(input_.gltf, input_.name + ".glb");
    if (!moving) {
        return badInput(moving.error().sentence);
    }
    if (static_cast<std::size_t>(flags_.animation) >= moving->animations()) {
        return badInput("--animation " + std::to_string(flags_.animation) + ": " + input_.name +
                        " has " + std::to_string(moving->animations()) + " animations");
    }
    moving_ = std::move(*moving);
    return std::nullopt;
}

MaybeFailure BakeToPoses::beginRound(std::size_t round) {
    Result<PosedModel, LoadError> posed =
        moving_->posedAt(static_cast<std::size_t>(flags_.animation), double{flags_.poses[round]});
    if (!posed) {
        return badInput(posed.error().sentence);
    }
    posed_ = std::move(*posed);
    for (std::size_t i = 0; i < input_.pieces.size(); ++i) {
        input_.pieces[i].surface = placedSurface(posed_.model.meshes[i]);
    }
    return std::nullopt;
}

AoStatus BakeToPoses::bake(bake::AbstractBaker& baker, const bake::BakeProgress& progress) {
    Result<std::vector<bake::BakedVertices>> baked = baker.bakeVertices(flags_.vertices, progress);
    if (!baked) {
        return baked.status();
    }
    for (std::size_t piece = 0; piece < baked->size(); ++piece) {
        std::vector<glm::vec3>& normals = (*baked)[piece].bentNormal;
        for (std::size_t i = 0; i < normals.size(); ++i) {
            normals[i] = posed_.atRest(piece, i, normals[i]);
        }
    }
    poses_.push_back(std::move(*baked));
    return {};
}

Result<std::string, Failure> BakeToPoses::put(OutputFiles& /*files*/) {
    std::vector<std::string> header{"piece", "vertices"};
    for (const float time : flags_.poses) {
        header.push_back(knownNumber(double{time}, 2) + " s");
    }
    Table table(header);
    for (std::size_t i = 0; i < input_.pieces.size(); ++i) {
        const GltfOrigin origin = input_.pieces[i].origin;
        const int mesh = input_.edit.ownMesh(origin.node);
        for (BakePiece& other : input_.pieces) {
            other.origin.mesh = other.origin.node == origin.node ? mesh : other.origin.mesh;
        }
        std::vector<std::string> row{input_.pieces[i].name,
                                     grouped(poses_[0][i].visibility.size())};
        for (std::size_t pose = 0; pose < poses_.size(); ++pose) {
            const std::vector<float>& values = poses_[pose][i].visibility;
            double sum = 0.0;
            for (const float w : values) {
                sum += double(w);
            }
            row.push_back(knownNumber(sum / double(values.size()), 3));
            input_.edit.setAttribute(mesh, origin.primitive, "_AO_" + std::to_string(pose),
                                     input_.edit.addFloats(values, 1));
            input_.edit.setAttribute(
                mesh, origin.primitive, "_BENT_NORMAL_" + std::to_string(pose),
                input_.edit.addFloats(componentsOf(poses_[pose][i].bentNormal), 3));
        }
        input_.edit.setExtra(mesh, origin.primitive, "aolib_pose_times", flags_.poses);
        table.add(row);
    }
    return "Mean W of each pose:\n" + table.text();
}

} // namespace aolib::app
