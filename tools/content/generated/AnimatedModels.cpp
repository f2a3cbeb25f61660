#include "content/generated/AnimatedModels.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "content/GltfContent.h"
#include "content/Model.h"
#include "scene/Bounds.h"

namespace aolib {

namespace {

using Json = GltfContent::Json;

constexpr float seconds = 2.0F;

/// Points and triangles.
struct Tube {
    std::vector<glm::vec3> positions;
    std::vector<std::uint32_t> indices;
};

/// A tube about +Y with a lid at each end.
/// @param radius  by height, from 0 to 1.
template <typename Radius>
Tube tubeOf(float length, int rings, int segments, const Radius& radius) {
    Tube tube;
    for (int ring = 0; ring <= rings; ++ring) {
        const float share = float(ring) / float(rings);
        for (int i = 0; i < segments; ++i) {
            const float turn = 2.0F * std::numbers::pi_v<float> * float(i) / float(segments);
            tube.positions.emplace_back(radius(share) * std::cos(turn), length * share,
                                        radius(share) * std::sin(turn));
        }
    }
    const auto at = [&](int ring, int i) {
        return static_cast<std::uint32_t>(ring * segments + i % segments);
    };
    const auto bottom = static_cast<std::uint32_t>(tube.positions.size());
    tube.positions.emplace_back(0.0F);
    tube.positions.emplace_back(0.0F, length, 0.0F);
    for (int i = 0; i < segments; ++i) {
        for (int ring = 0; ring < rings; ++ring) {
            const std::uint32_t a = at(ring, i);
            const std::uint32_t b = at(ring, i + 1);
            const std::uint32_t c = at(ring + 1, i + 1);
            const std::uint32_t d = at(ring + 1, i);
            tube.indices.insert(tube.indices.end(), {a, d, c, a, c, b});
        }
        tube.indices.insert(tube.indices.end(), {bottom, at(0, i), at(0, i + 1), bottom + 1,
                                                 at(rings, i + 1), at(rings, i)});
    }
    return tube;
}

/// Puts a GLB together.
class Builder {
public:
    explicit Builder(const std::string& name) {
        content_.name = name;
        content_.json["asset"] = {{"version", "2.0"}, {"generator", "aolib"}};
        content_.json["scene"] = 0;
    }

    template <typename T>
    int accessor(const std::vector<T>& values, const char* type, int component, int target) {
        const std::string_view bytes(reinterpret_cast<const char*>(values.data()),
                                     values.size() * sizeof(T));
        Json element{{"bufferView", content_.addView(bytes, target)},
                     {"componentType", component},
                     {"count", values.size()},
                     {"type", type}};
        return content_.add("accessors", std::move(element));
    }
    int positions(const std::vector<glm::vec3>& values, int target = kGltfArrayBuffer) {
        const int number = accessor(values, "VEC3", kGltfFloat, target);
        Bounds bounds;
        for (const glm::vec3& value : values) {
            bounds.include(value);
        }
        Json& element = content_.json["accessors"].back();
        element["min"] = {bounds.min.x, bounds.min.y, bounds.min.z};
        element["max"] = {bounds.max.x, bounds.max.y, bounds.max.z};
        return number;
    }
    Json primitive(const std::vector<glm::vec3>& vertices,
                   const std::vector<std::uint32_t>& indices) {
        Json result;
        result["attributes"]["POSITION"] = positions(vertices);
        result["attributes"]["NORMAL"] =
            accessor(smoothNormals(vertices, indices), "VEC3", kGltfFloat, kGltfArrayBuffer);
        result["indices"] = accessor(indices, "SCALAR", kGltfUnsignedInt, kGltfElementArrayBuffer);
        return result;
    }
    int mesh(Json primitive) {
        Json element;
        element["primitives"] = Json::array({std::move(primitive)});
        return content_.add("meshes", std::move(element));
    }
    int add(const char* array, Json element) { return content_.add(array, std::move(element)); }
    /// An animation of one property over all of the time.
    template <typename T>
    void animate(int node, const char* path, const std::vector<T>& values, const char* type) {
        std::vector<float> times;
        for (std::size_t i = 0; i < values.size(); ++i) {
            times.push_back(seconds * float(i) / float(values.size() - 1));
        }
        const int input = accessor(times, "SCALAR", kGltfFloat, 0);
        content_.json["accessors"].back()["min"] = {times.front()};
        content_.json["accessors"].back()["max"] = {times.back()};
        const int output = accessor(values, type, kGltfFloat, 0);
        Json animation;
        animation["samplers"] = Json::array({{{"input", input}, {"output", output}}});
        animation["channels"] =
            Json::array({{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}});
        content_.add("animations", std::move(animation));
    }
    Result<std::string, LoadError> glb(const std::vector<int>& roots) {
        Json scene;
        scene["nodes"] = roots;
        content_.json["scenes"] = Json::array({std::move(scene)});
        return content_.glb();
    }

private:
    GltfContent content_;
};

/// Rotations about +Z in equal steps, a key each.
std::vector<glm::vec4> turns(float fromDegrees, float toDegrees) {
    std::vector<glm::vec4> keys;
    constexpr int steps = 8;
    for (int i = 0; i <= steps; ++i) {
        const float angle =
            glm::radians(fromDegrees + (toDegrees - fromDegrees) * float(i) / float(steps));
        const glm::quat q = glm::angleAxis(angle, glm::vec3(0.0F, 0.0F, 1.0F));
        keys.emplace_back(q.x, q.y, q.z, q.w);
    }
    return keys;
}

Result<std::string, LoadError> buildArm() {
    constexpr float length = 4.0F;
    constexpr float elbow = 0.5F * length;
    constexpr float soft = 0.35F; // half of the length over which the elbow bends
    const Tube tube = tubeOf(length, 80, 32, [](float) { return 0.4F; });
    Builder builder("arm");
    Json primitive = builder.primitive(tube.positions, tube.indices);
    std::vector<std::uint32_t> joints; // four bytes a vertex
    std::vector<glm::vec4> weights;
    for (const glm::vec3& position : tube.positions) {
        const float upper = std::clamp((position.y - elbow) / (2.0F * soft) + 0.5F, 0.0F, 1.0F);
        joints.push_back(0x00000100U); // 0, 1, 0, 0 in this order of bytes
        weights.emplace_back(1.0F - upper, upper, 0.0F, 0.0F);
    }
    constexpr int unsignedByte = 5121;
    primitive["attributes"]["JOINTS_0"] =
        builder.accessor(joints, "VEC4", unsignedByte, kGltfArrayBuffer);
    primitive["attributes"]["WEIGHTS_0"] =
        builder.accessor(weights, "VEC4", kGltfFloat, kGltfArrayBuffer);
    const int mesh = builder.mesh(std::move(primitive));
    const std::vector<glm::mat4> fromMesh{
        glm::mat4(1.0F), glm::translate(glm::mat4(1.0F), glm::vec3(0.0F, -elbow, 0.0F))};
    const int matrices = builder.accessor(fromMesh, "MAT4", kGltfFloat, 0);
    builder.add("nodes", {{"name", "arm"}, {"mesh", mesh}, {"skin", 0}});
    builder.add("nodes", {{"name", "shoulder"}, {"children", {2}}});
    builder.add("nodes", {{"name", "elbow"}, {"translation", {0.0F, elbow, 0.0F}}});
    builder.add("skins", {{"joints", {1, 2}}, {"inverseBindMatrices", matrices}});
    builder.animate(2, "rotation", turns(0.0F, 140.0F), "VEC4");
    return builder.glb({0, 1});
}

/// A plate of 2 x 2 in x and z, from the axis along z, a grid on all sides.
Tube plate() {
    constexpr int cells = 24;
    constexpr float thickness = 0.08F;
    Tube result;
    const auto side = [&](glm::vec3 corner, glm::vec3 a, glm::vec3 b, int alongA, int alongB) {
        const auto first = static_cast<std::uint32_t>(result.positions.size());
        for (int j = 0; j <= alongB; ++j) {
            for (int i = 0; i <= alongA; ++i) {
                result.positions.push_back(corner + a * (float(i) / float(alongA)) +
                                           b * (float(j) / float(alongB)));
            }
        }
        const auto at = [&](int i, int j) {
            return first + static_cast<std::uint32_t>(j * (alongA + 1) + i);
        };
        for (int j = 0; j < alongB; ++j) {
            for (int i = 0; i < alongA; ++i) {
                result.indices.insert(result.indices.end(),
                                      {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j),
                                       at(i + 1, j + 1), at(i, j + 1)});
            }
        }
    };
    const glm::vec3 low(0.05F, 0.0F, -1.0F);
    const glm::vec3 x(2.0F, 0.0F, 0.0F);
    const glm::vec3 y(0.0F, thickness, 0.0F);
    const glm::vec3 z(0.0F, 0.0F, 2.0F);
    side(low + y, z, x, cells, cells);
    side(low, x, z, cells, cells);
    side(low, y, x, 1, cells);
    side(low + z, x, y, cells, 1);
    side(low, z, y, cells, 1);
    side(low + x, y, z, 1, cells);
    return result;
}

Result<std::string, LoadError> buildHinge() {
    Builder builder("hinge");
    const Tube half = plate();
    const int mesh = builder.mesh(builder.primitive(half.positions, half.indices));
    builder.add("nodes", {{"name", "lower"}, {"mesh", mesh}});
    // The other half, turned over so that its face looks up when it lies open.
    std::vector<glm::vec3> mirrored = half.positions;
    for (glm::vec3& p : mirrored) {
        p = glm::vec3(p.x, -p.y, p.z) + glm::vec3(0.0F, 0.08F, 0.0F);
    }
    std::vector<std::uint32_t> turned = half.indices;
    for (std::size_t i = 0; i < turned.size(); i += 3) {
        std::swap(turned[i + 1], turned[i + 2]);
    }
    const int lid = builder.mesh(builder.primitive(mirrored, turned));
    builder.add("nodes", {{"name", "lid"}, {"mesh", lid}});
    builder.animate(1, "rotation", turns(170.0F, 12.0F), "VEC4");
    return builder.glb({0, 1});
}

Result<std::string, LoadError> buildBellows() {
    Builder builder("bellows");
    const auto folds = [](float share) {
        return 1.0F + 0.25F * std::cos(2.0F * std::numbers::pi_v<float> * 6.0F * share);
    };
    const Tube tube = tubeOf(4.0F, 144, 32, folds);
    Json primitive = builder.primitive(tube.positions, tube.indices);
    std::vector<glm::vec3> offsets;
    std::vector<glm::vec3> folded;
    for (const glm::vec3& p : tube.positions) {
        offsets.emplace_back(0.0F, -0.75F * p.y, 0.0F);
        folded.push_back(p + offsets.back());
    }
    const std::vector<glm::vec3> before = smoothNormals(tube.positions, tube.indices);
    std::vector<glm::vec3> turned = smoothNormals(folded, tube.indices);
    for (std::size_t i = 0; i < turned.size(); ++i) {
        turned[i] -= before[i];
    }
    Json target;
    target["POSITION"] = builder.positions(offsets);
    target["NORMAL"] = builder.accessor(turned, "VEC3", kGltfFloat, kGltfArrayBuffer);
    primitive["targets"] = Json::array({std::move(target)});
    const int mesh = builder.mesh(std::move(primitive));
    builder.add("nodes", {{"name", "bellows"}, {"mesh", mesh}});
    builder.animate(0, "weights", std::vector<float>{0.0F, 1.0F}, "SCALAR");
    return builder.glb({0});
}

} // namespace

std::vector<std::string> animatedModelNames() {
    return {"arm", "hinge", "bellows"};
}

Result<std::string, LoadError> animatedModel(std::string_view name) {
    if (name == "arm") {
        return buildArm();
    }
    if (name == "hinge") {
        return buildHinge();
    }
    if (name == "bellows") {
        return buildBellows();
    }
    return LoadError{std::string(name) + ": no animated model of this name"};
}

} // namespace aolib
