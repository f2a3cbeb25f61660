#include "content/GltfAccessor.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

namespace aolib {
namespace {

/// Accessors without a buffer view are zeros and cost no bytes in the file; beyond this they are
/// taken for damage.
constexpr std::size_t mostImplicitElements = std::size_t{1} << 24;

/// Bytes of a buffer that are known to hold `count` elements.
struct ByteRun {
    const char* first = nullptr;
    std::size_t stride = 0;
};

class AccessorReader {
public:
    AccessorReader(const GltfDocument& document, int index) : document_(document), index_(index) {}

    template <typename Vector>
    Result<std::vector<Vector>, LoadError> vectors() const;
    Result<std::vector<std::uint32_t>, LoadError> indices() const;

private:
    LoadError failure(const std::string& reason) const {
        return LoadError{document_.name + ": accessor " + std::to_string(index_) + " " + reason};
    }
    const tinygltf::Accessor* find() const;
    Result<ByteRun, LoadError> locate(std::int64_t view, std::uint64_t offset, std::size_t count,
                                      std::size_t elementSize) const;
    Result<std::vector<std::uint32_t>, LoadError>
    sparseIndices(const tinygltf::Accessor& accessor) const;

    const GltfDocument& document_;
    int index_;
};

template <typename T>
T load(const char* bytes) {
    T value{};
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

template <typename T>
float toFloat(const char* bytes, bool normalised) {
    const auto value = static_cast<float>(load<T>(bytes));
    if constexpr (std::is_integral_v<T>) {
        if (normalised) {
            return std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0F);
        }
    }
    return value;
}

std::size_t componentSize(int type) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return 4;
    default:
        return 0;
    }
}

float readComponent(const char* bytes, int type, bool normalised) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
        return toFloat<std::int8_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return toFloat<std::uint8_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return toFloat<std::int16_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return toFloat<std::uint16_t>(bytes, normalised);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return toFloat<std::uint32_t>(bytes, normalised);
    default:
        return load<float>(bytes);
    }
}

std::uint32_t readIndex(const char* bytes, int type) {
    switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return load<std::uint8_t>(bytes);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return load<std::uint16_t>(bytes);
    default:
        return load<std::uint32_t>(bytes);
    }
}

bool isIndexType(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

/// An element of so many numbers, where GLM has no vector of them.
template <int Count>
struct Numbers {
    explicit Numbers(float value = 0.0F) { numbers.fill(value); }
    float& operator[](int i) { return numbers[static_cast<std::size_t>(i)]; }
    static constexpr int length() { return Count; }

    std::array<float, static_cast<std::size_t>(Count)> numbers{};
};

/// What glTF calls elements of so many numbers, and how messages do.
struct ElementKind {
    int type;
    const char* lacking;
};

constexpr ElementKind kindOf(int numbers) {
    switch (numbers) {
    case 1:
        return {TINYGLTF_TYPE_SCALAR, "does not hold single numbers"};
    case 2:
        return {TINYGLTF_TYPE_VEC2, "does not hold vectors of two numbers"};
    case 3:
        return {TINYGLTF_TYPE_VEC3, "does not hold vectors of three numbers"};
    case 4:
        return {TINYGLTF_TYPE_VEC4, "does not hold vectors of four numbers"};
    default:
        return {TINYGLTF_TYPE_MAT4, "does not hold matrices of sixteen numbers"};
    }
}

template <typename Vector>
Vector readVector(const char* bytes, int type, bool normalised) {
    const std::size_t size = componentSize(type);
    Vector result(0.0F);
    for (int i = 0; i < Vector::length(); ++i) {
        result[i] = readComponent(bytes + static_cast<std::size_t>(i) * size, type, normalised);
    }
    return result;
}

const tinygltf::Accessor* AccessorReader::find() const {
    const auto& accessors = document_.structure.accessors;
    return index_ >= 0 && static_cast<std::size_t>(index_) < accessors.size()
               ? &accessors[static_cast<std::size_t>(index_)]
               : nullptr;
}

Result<ByteRun, LoadError> AccessorReader::locate(std::int64_t view, std::uint64_t offset,
                                                  std::size_t count,
                                                  std::size_t elementSize) const {
    const auto& views = document_.structure.bufferViews;
    if (view < 0 || static_cast<std::size_t>(view) >= views.size()) {
        return failure("names buffer view " + std::to_string(view) + ", which does not exist");
    }
    const tinygltf::BufferView& bytes = views[static_cast<std::size_t>(view)];
    if (bytes.buffer < 0 || static_cast<std::size_t>(bytes.buffer) >= document_.buffers.size()) {
        return failure("lies in buffer " + std::to_string(bytes.buffer) + ", which does not exist");
    }
    const std::string& buffer = document_.buffers[static_cast<std::size_t>(bytes.buffer)];
    const std::uint64_t start = bytes.byteOffset;
    const std::uint64_t length = bytes.byteLength;
    if (start > buffer.size() || length > buffer.size() - start) {
        return failure("lies in a buffer view that reaches past the end of its buffer");
    }
    const std::size_t stride = bytes.byteStride != 0 ? bytes.byteStride : elementSize;
    if (stride < elementSize) {
        return failure("has elements wider than their stride");
    }
    const bool fits = count == 0 || (offset <= length && elementSize <= length - offset &&
                                     count - 1 <= (length - offset - elementSize) / stride);
    if (!fits) {
        return failure("with " + std::to_string(count) +
                       " elements reaches past the end of its buffer view");
    }
    return ByteRun{count == 0 ? buffer.data() : buffer.data() + start + offset, stride};
}

Result<std::vector<std::uint32_t>, LoadError>
AccessorReader::sparseIndices(const tinygltf::Accessor& accessor) const {
    const int type = accessor.sparse.indices.componentType;
    if (!isIndexType(type)) {
        return failure("has sparse indices of an unknown type");
    }
    // Later versions of tinygltf have unsigned offsets.
    if (accessor.sparse.count < 0 || std::cmp_less(accessor.sparse.indices.byteOffset, 0) ||
        std::cmp_less(accessor.sparse.values.byteOffset, 0)) {
        return failure("has a negative sparse count or offset");
    }
    const auto count = static_cast<std::size_t>(accessor.sparse.count);
    const Result<ByteRun, LoadError> run = locate(
        accessor.sparse.indices.bufferView,
        static_cast<std::uint64_t>(accessor.sparse.indices.byteOffset), count, componentSize(type));
    if (!run) {
        return run.error();
    }
    std::vector<std::uint32_t> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        result[i] = readIndex(run->first + i * run->stride, type);
        if (result[i] >= accessor.count) {
            return failure("has sparse index " + std::to_string(result[i]) + " of " +
                           std::to_string(accessor.count) + " elements");
        }
    }
    return result;
}

template <typename Vector>
Result<std::vector<Vector>, LoadError> AccessorReader::vectors() const {
    constexpr ElementKind kind = kindOf(Vector::length());
    const tinygltf::Accessor* accessor = find();
    if (accessor == nullptr) {
        return failure("does not exist");
    }
    const int type = accessor->componentType;
    if (accessor->type != kind.type || componentSize(type) == 0) {
        return failure(kind.lacking);
    }
    const std::size_t size = std::size_t{Vector::length()} * componentSize(type);
    std::vector<Vector> result;
    if (accessor->bufferView >= 0) {
        const Result<ByteRun, LoadError> run =
            locate(accessor->bufferView, accessor->byteOffset, accessor->count, size);
        if (!run) {
            return run.error();
        }
        result.resize(accessor->count, Vector(0.0F));
        for (std::size_t i = 0; i < result.size(); ++i) {
            result[i] =
                readVector<Vector>(run->first + i * run->stride, type, accessor->normalized);
        }
    } else if (accessor->count > mostImplicitElements) {
        return failure("has " + std::to_string(accessor->count) + " elements without any bytes");
    } else {
        result.resize(accessor->count, Vector(0.0F));
    }
    if (!accessor->sparse.isSparse) {
        return result;
    }
    const Result<std::vector<std::uint32_t>, LoadError> places = sparseIndices(*accessor);
    if (!places) {
        return places.error();
    }
    const Result<ByteRun, LoadError> run = locate(
        accessor->sparse.values.bufferView,
        static_cast<std::uint64_t>(accessor->sparse.values.byteOffset), places->size(), size);
    if (!run) {
        return run.error();
    }
    for (std::size_t i = 0; i < places->size(); ++i) {
        result[(*places)[i]] =
            readVector<Vector>(run->first + i * run->stride, type, accessor->normalized);
    }
    return result;
}

Result<std::vector<std::uint32_t>, LoadError> AccessorReader::indices() const {
    const tinygltf::Accessor* accessor = find();
    if (accessor == nullptr) {
        return failure("does not exist");
    }
    const int type = accessor->componentType;
    if (accessor->type != TINYGLTF_TYPE_SCALAR || !isIndexType(type) || accessor->sparse.isSparse) {
        return failure("does not hold indices");
    }
    const Result<ByteRun, LoadError> run =
        locate(accessor->bufferView, accessor->byteOffset, accessor->count, componentSize(type));
    if (!run) {
        return run.error();
    }
    std::vector<std::uint32_t> result(accessor->count);
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = readIndex(run->first + i * run->stride, type);
    }
    return result;
}

} // namespace

Result<std::vector<glm::vec3>, LoadError> readVectors(const GltfDocument& document, int accessor) {
    return AccessorReader(document, accessor).vectors<glm::vec3>();
}

Result<std::vector<glm::vec2>, LoadError> readPairs(const GltfDocument& document, int accessor) {
    return AccessorReader(document, accessor).vectors<glm::vec2>();
}

Result<std::vector<glm::vec4>, LoadError> readQuads(const GltfDocument& document, int accessor) {
    return AccessorReader(document, accessor).vectors<glm::vec4>();
}

Result<std::vector<float>, LoadError> readNumbers(const GltfDocument& document, int accessor) {
    const auto read = AccessorReader(document, accessor).vectors<Numbers<1>>();
    if (!read) {
        return read.error();
    }
    std::vector<float> numbers;
    for (const Numbers<1>& value : *read) {
        numbers.push_back(value.numbers[0]);
    }
    return numbers;
}

Result<std::vector<glm::mat4>, LoadError> readMatrices(const GltfDocument& document, int accessor) {
    const auto read = AccessorReader(document, accessor).vectors<Numbers<16>>();
    if (!read) {
        return read.error();
    }
    std::vector<glm::mat4> matrices;
    for (const Numbers<16>& value : *read) {
        matrices.push_back(glm::make_mat4(value.numbers.data()));
    }
    return matrices;
}

Result<std::vector<std::uint32_t>, LoadError> readIndices(const GltfDocument& document,
                                                          int accessor) {
    return AccessorReader(document, accessor).indices();
}

} // namespace aolib
