#include "content/GltfGather.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace aolib {

namespace {

using Json = GltfContent::Json;

std::size_t componentBytes(int type) {
    switch (type) {
    case 5120:
    case 5121:
        return 1;
    case 5122:
    case 5123:
        return 2;
    default:
        return 4;
    }
}

std::size_t componentCount(const std::string& type) {
    static const std::map<std::string, std::size_t> counts{{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3},
                                                           {"VEC4", 4},   {"MAT2", 4}, {"MAT3", 9},
                                                           {"MAT4", 16}};
    return counts.at(type);
}

/// An accessor whose element i is a copy of another one's `source[i]`.
Result<int, LoadError> gathered(GltfContent& content, int accessor,
                                const std::vector<std::uint32_t>& source) {
    Json made = content.json.at("accessors").at(GltfContent::index(accessor));
    if (made.contains("sparse") || !made.contains("bufferView")) {
        return LoadError{content.name + ": accessor " + std::to_string(accessor) +
                         " is sparse: its vertices cannot be split"};
    }
    const Json& view = content.json.at("bufferViews").at(made["bufferView"].get<std::size_t>());
    const std::string type = made.at("type").get<std::string>();
    const int component = made.at("componentType").get<int>();
    const std::size_t size = componentCount(type) * componentBytes(component);
    const std::size_t stride = view.value("byteStride", size);
    const std::size_t start =
        view.value("byteOffset", std::size_t{0}) + made.value("byteOffset", std::size_t{0});
    const std::size_t newStride = alignedToFour(size);
    std::string bytes(newStride * source.size(), '\0');
    for (std::size_t i = 0; i < source.size(); ++i) {
        const std::size_t from = start + source[i] * stride;
        if (from + size > content.binary.size()) {
            return LoadError{content.name + ": accessor " + std::to_string(accessor) +
                             " reaches past the end of its buffer"};
        }
        std::memcpy(&bytes[i * newStride], &content.binary[from], size);
    }
    made.erase("byteOffset");
    made["count"] = source.size();
    if (made.contains("min") && component == kGltfFloat) {
        const std::size_t count = componentCount(type);
        std::vector<float> low(count, std::numeric_limits<float>::infinity());
        std::vector<float> high(count, -std::numeric_limits<float>::infinity());
        for (std::size_t i = 0; i < source.size() * count; ++i) {
            float value = 0.0F;
            std::memcpy(&value, &bytes[i * sizeof(float)], sizeof(float));
            low[i % count] = std::min(low[i % count], value);
            high[i % count] = std::max(high[i % count], value);
        }
        made["min"] = low;
        made["max"] = high;
    } else {
        made.erase("min");
        made.erase("max");
    }
    made["bufferView"] = content.addView(bytes, kGltfArrayBuffer, newStride);
    return content.add("accessors", std::move(made));
}

} // namespace

std::optional<LoadError> gatherVertices(GltfContent& content, Json& attributes,
                                        const std::vector<std::uint32_t>& source) {
    for (auto& [key, value] : attributes.items()) {
        const Result<int, LoadError> made = gathered(content, value.get<int>(), source);
        if (!made) {
            return made.error();
        }
        value = *made;
    }
    return std::nullopt;
}

} // namespace aolib
