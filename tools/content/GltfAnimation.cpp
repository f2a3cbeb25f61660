#include "content/GltfAnimation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <glm/gtc/quaternion.hpp>

#include "content/GltfAccessor.h"

namespace aolib {

namespace {

using Path = GltfTrack::Path;
using Interpolation = GltfTrack::Interpolation;

glm::dquat quaternionOf(const std::vector<double>& v) {
    return {v[3], v[0], v[1], v[2]};
}

std::vector<double> numbersOf(const glm::dquat& q) {
    return {q.x, q.y, q.z, q.w};
}

std::optional<Path> pathOf(const std::string& name) {
    if (name == "translation") {
        return Path::Translation;
    }
    if (name == "rotation") {
        return Path::Rotation;
    }
    if (name == "scale") {
        return Path::Scale;
    }
    return name == "weights" ? std::optional<Path>(Path::Weights) : std::nullopt;
}

std::vector<float> flattened(const std::vector<glm::vec3>& vectors) {
    std::vector<float> numbers;
    for (const glm::vec3& v : vectors) {
        numbers.insert(numbers.end(), {v.x, v.y, v.z});
    }
    return numbers;
}

std::vector<float> flattened(const std::vector<glm::vec4>& vectors) {
    std::vector<float> numbers;
    for (const glm::vec4& v : vectors) {
        numbers.insert(numbers.end(), {v.x, v.y, v.z, v.w});
    }
    return numbers;
}

Result<std::vector<float>, LoadError> valuesOf(const GltfDocument& document, int accessor,
                                               Path path) {
    if (path == Path::Weights) {
        return readNumbers(document, accessor);
    }
    if (path == Path::Rotation) {
        const auto read = readQuads(document, accessor);
        return read ? flattened(*read) : Result<std::vector<float>, LoadError>(read.error());
    }
    const auto read = readVectors(document, accessor);
    return read ? flattened(*read) : Result<std::vector<float>, LoadError>(read.error());
}

class AnimationReader {
public:
    AnimationReader(const GltfDocument& document, std::size_t number)
        : document_(document), source_(document.structure.animations[number]),
          where_(document.name + ": animation " + std::to_string(number)) {}

    Result<GltfAnimation, LoadError> read() const;

private:
    LoadError failure(std::size_t channel, const std::string& reason) const {
        return LoadError{where_ + ", channel " + std::to_string(channel) + ": " + reason};
    }
    Result<GltfTrack, LoadError> track(std::size_t channel, Path path) const;

    const GltfDocument& document_;
    const tinygltf::Animation& source_;
    std::string where_;
};

Result<GltfTrack, LoadError> AnimationReader::track(std::size_t channel, Path path) const {
    const tinygltf::AnimationChannel& description = source_.channels[channel];
    if (description.sampler < 0 ||
        static_cast<std::size_t>(description.sampler) >= source_.samplers.size()) {
        return failure(channel, "its sampler does not exist");
    }
    if (static_cast<std::size_t>(description.target_node) >= document_.structure.nodes.size()) {
        return failure(channel, "its node does not exist");
    }
    const auto& sampler = source_.samplers[static_cast<std::size_t>(description.sampler)];
    GltfTrack track;
    track.node = description.target_node;
    track.path = path;
    track.interpolation = sampler.interpolation == "STEP"          ? Interpolation::Step
                          : sampler.interpolation == "CUBICSPLINE" ? Interpolation::CubicSpline
                                                                   : Interpolation::Linear;
    Result<std::vector<float>, LoadError> times = readNumbers(document_, sampler.input);
    if (!times) {
        return times.error();
    }
    Result<std::vector<float>, LoadError> values = valuesOf(document_, sampler.output, path);
    if (!values) {
        return values.error();
    }
    track.times = std::move(*times);
    track.values = std::move(*values);
    const auto finite = [](float value) { return std::isfinite(value); };
    if (track.times.empty() || !std::all_of(track.times.begin(), track.times.end(), finite) ||
        std::adjacent_find(track.times.begin(), track.times.end(), std::greater_equal<>()) !=
            track.times.end()) {
        return failure(channel, "its times do not grow");
    }
    if (!std::all_of(track.values.begin(), track.values.end(), finite)) {
        return failure(channel, "a value is not finite");
    }
    const std::size_t sets =
        track.times.size() * (track.interpolation == Interpolation::CubicSpline ? 3 : 1);
    track.components = track.values.size() / sets;
    const std::size_t needed = path == Path::Rotation ? 4 : 3;
    if (track.components == 0 || track.components * sets != track.values.size() ||
        (path != Path::Weights && track.components != needed)) {
        return failure(channel, std::to_string(track.values.size()) + " numbers for " +
                                    std::to_string(track.times.size()) + " keys");
    }
    return track;
}

Result<GltfAnimation, LoadError> AnimationReader::read() const {
    GltfAnimation tracks;
    for (std::size_t channel = 0; channel < source_.channels.size(); ++channel) {
        const std::optional<Path> path = pathOf(source_.channels[channel].target_path);
        if (!path || source_.channels[channel].target_node < 0) {
            continue;
        }
        Result<GltfTrack, LoadError> read = track(channel, *path);
        if (!read) {
            return read.error();
        }
        tracks.push_back(std::move(*read));
    }
    return tracks;
}

/// What lies between two keys, and how far from the first, 0 to 1.
struct Segment {
    std::size_t first = 0;
    std::size_t last = 0;
    double part = 0.0;
    double seconds = 0.0; ///< from one to the other
};

Segment segmentAt(const std::vector<float>& times, double seconds) {
    const auto after = std::upper_bound(times.begin(), times.end(), seconds);
    if (after == times.begin()) {
        return {};
    }
    const auto first = static_cast<std::size_t>(after - times.begin()) - 1;
    if (after == times.end()) {
        return {first, first, 0.0, 0.0};
    }
    const double length = double{times[first + 1]} - double{times[first]};
    return {first, first + 1, (seconds - double{times[first]}) / length, length};
}

} // namespace

std::vector<double> GltfTrack::at(double seconds) const {
    const Segment segment = segmentAt(times, seconds);
    const bool cubic = interpolation == Interpolation::CubicSpline;
    // Of a key: 0 in-tangent, 1 value, 2 out-tangent where there are any.
    const auto numbers = [&](std::size_t key, std::size_t which) {
        const std::size_t begin = (cubic ? 3 * key + which : key) * components;
        return std::vector<double>(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                   values.begin() +
                                       static_cast<std::ptrdiff_t>(begin + components));
    };
    std::vector<double> result = numbers(segment.first, 1);
    if (segment.part > 0.0 && interpolation != Interpolation::Step) {
        const std::vector<double> next = numbers(segment.last, 1);
        const double t = segment.part;
        if (cubic) { // glTF 2.0, appendix C.4
            const std::vector<double> leaving = numbers(segment.first, 2);
            const std::vector<double> arriving = numbers(segment.last, 0);
            for (std::size_t i = 0; i < components; ++i) {
                result[i] = (2.0 * t * t * t - 3.0 * t * t + 1.0) * result[i] +
                            segment.seconds * (t * t * t - 2.0 * t * t + t) * leaving[i] +
                            (3.0 * t * t - 2.0 * t * t * t) * next[i] +
                            segment.seconds * (t * t * t - t * t) * arriving[i];
            }
        } else if (path == Path::Rotation) {
            result = numbersOf(glm::slerp(glm::normalize(quaternionOf(result)),
                                          glm::normalize(quaternionOf(next)), t));
        } else {
            for (std::size_t i = 0; i < components; ++i) {
                result[i] += t * (next[i] - result[i]);
            }
        }
    }
    if (path == Path::Rotation) {
        const glm::dquat rotation = quaternionOf(result);
        const double length = glm::length(rotation);
        result = numbersOf(length > 0.0 ? rotation / length : glm::dquat(1.0, 0.0, 0.0, 0.0));
    }
    return result;
}

Result<std::vector<GltfAnimation>, LoadError> readAnimations(const GltfDocument& document) {
    std::vector<GltfAnimation> animations;
    for (std::size_t i = 0; i < document.structure.animations.size(); ++i) {
        Result<GltfAnimation, LoadError> animation = AnimationReader(document, i).read();
        if (!animation) {
            return animation.error();
        }
        animations.push_back(std::move(*animation));
    }
    return animations;
}

} // namespace aolib
