#include "SmallGltf.h"

#include <cstdint>
#include <cstring>

#include <gtest/gtest.h>

namespace aolib::test {
namespace {

std::string word(std::size_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) {
        bytes += static_cast<char>((value >> (8 * i)) & 0xFFU);
    }
    return bytes;
}

template <typename T>
std::string bytesOf(std::initializer_list<T> values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::size_t at = 0;
    for (const T& value : values) {
        std::memcpy(bytes.data() + at, &value, sizeof(T));
        at += sizeof(T);
    }
    return bytes;
}

} // namespace

std::string packGlb(std::string json, std::string binary) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    std::string chunks = word(json.size()) + "JSON" + json;
    if (!binary.empty()) {
        chunks += word(binary.size()) + std::string("BIN\0", 4) + binary;
    }
    return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
}

std::string floatBytes(std::initializer_list<float> values) {
    return bytesOf(values);
}
std::string shortBytes(std::initializer_list<unsigned short> values) {
    return bytesOf(values);
}

std::string quadBytes() {
    return floatBytes({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) +
           floatBytes({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}) + shortBytes({0, 1, 2, 0, 2, 3});
}

std::string quadJson(const std::string& nodes, const std::string& extra) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":)" + nodes +
           R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"indices":2}]}],
            "buffers":[{"byteLength":108}],
            "bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},
                           {"buffer":0,"byteOffset":48,"byteLength":48},
                           {"buffer":0,"byteOffset":96,"byteLength":12}],
            "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
                         {"bufferView":1,"componentType":5126,"count":4,"type":"VEC3"},
                         {"bufferView":2,"componentType":5123,"count":6,"type":"SCALAR"}])" +
           extra + "}";
}

std::string quadGlb(const std::string& nodes, const std::string& extra) {
    return packGlb(quadJson(nodes, extra), quadBytes());
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << "the text does not hold " << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

} // namespace aolib::test
