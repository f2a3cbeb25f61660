#include "content/ObjReader.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace aolib {
namespace {

constexpr std::int64_t noIndex = -1;

struct Corner {
    std::int64_t position = noIndex;
    std::int64_t normal = noIndex;
};

struct Face {
    std::size_t firstCorner = 0;
    std::size_t cornerCount = 0;
    std::size_t line = 0;
};

/// The words of one line, split at blanks, up to a comment.
std::vector<std::string_view> wordsOf(std::string_view line) {
    std::vector<std::string_view> words;
    std::size_t at = 0;
    while (at < line.size() && line[at] != '#') {
        if (line[at] == ' ' || line[at] == '\t' || line[at] == '\r' || line[at] == '\\') {
            ++at;
            continue;
        }
        const std::size_t end = std::min(line.find_first_of(" \t\r\\#", at), line.size());
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

std::optional<float> parseFloat(std::string_view word) {
    if (!word.empty() && word.front() == '+') {
        word.remove_prefix(1);
    }
    double value = 0.0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    const auto narrow = static_cast<float>(value);
    if (code != std::errc() || end != word.data() + word.size() || !std::isfinite(narrow)) {
        return std::nullopt;
    }
    return narrow;
}

class ObjParser {
public:
    explicit ObjParser(const std::filesystem::path& file) : file_(file) {}

    Result<Model, LoadError> parse(std::string_view text);

private:
    LoadError failure(const std::string& reason) const { return failure(reason, line_); }
    LoadError failure(const std::string& reason, std::size_t line) const {
        return LoadError{file_.string() + ", line " + std::to_string(line) + ": " + reason};
    }
    std::optional<LoadError> readLine(const std::vector<std::string_view>& words);
    std::optional<LoadError> readVector(const std::vector<std::string_view>& words,
                                        std::vector<glm::vec3>& out);
    std::optional<LoadError> readFace(const std::vector<std::string_view>& words);
    std::optional<std::int64_t> resolve(std::string_view word, std::size_t count) const;
    std::optional<LoadError> checkFaces() const;
    ModelMesh assemble() const;

    std::filesystem::path file_;
    std::size_t line_ = 0;
    std::vector<glm::vec3> positions_;
    std::vector<glm::vec3> normals_;
    std::vector<Corner> corners_;
    std::vector<Face> faces_;
};

Result<Model, LoadError> ObjParser::parse(std::string_view text) {
    while (!text.empty()) {
        std::size_t end = text.find('\n');
        ++line_;
        std::size_t joined = 0;
        while (end != std::string_view::npos && end > 0 &&
               (text[end - 1] == '\\' ||
                (end > 1 && text[end - 1] == '\r' && text[end - 2] == '\\'))) {
            end = text.find('\n', end + 1);
            ++joined;
        }
        std::string line(text.substr(0, end));
        for (char& c : line) {
            c = c == '\n' ? ' ' : c;
        }
        if (std::optional<LoadError> error = readLine(wordsOf(line))) {
            return *error;
        }
        line_ += joined;
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    if (std::optional<LoadError> error = checkFaces()) {
        return *error;
    }
    Model model;
    model.meshes.push_back(assemble());
    return model;
}

std::optional<LoadError> ObjParser::readLine(const std::vector<std::string_view>& words) {
    if (words.empty()) {
        return std::nullopt;
    }
    if (words[0] == "v") {
        return readVector(words, positions_);
    }
    if (words[0] == "vn") {
        return readVector(words, normals_);
    }
    return words[0] == "f" ? readFace(words) : std::nullopt;
}

std::optional<LoadError> ObjParser::readVector(const std::vector<std::string_view>& words,
                                               std::vector<glm::vec3>& out) {
    if (words.size() < 4) {
        return failure("'" + std::string(words[0]) + "' needs three numbers");
    }
    glm::vec3 value{0.0F};
    for (int axis = 0; axis < 3; ++axis) {
        const std::string_view word = words[static_cast<std::size_t>(axis) + 1];
        const std::optional<float> number = parseFloat(word);
        if (!number) {
            return failure("'" + std::string(word) + "' is not a finite number");
        }
        value[axis] = *number;
    }
    out.push_back(value);
    return std::nullopt;
}

/// Turns a 1-based or negative index into a 0-based one; nothing when it is no index at all.
std::optional<std::int64_t> ObjParser::resolve(std::string_view word, std::size_t count) const {
    std::int64_t value = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (code != std::errc() || end != word.data() + word.size() || value == 0) {
        return std::nullopt;
    }
    const std::int64_t index = value > 0 ? value - 1 : static_cast<std::int64_t>(count) + value;
    return index < 0 ? std::nullopt : std::optional<std::int64_t>(index);
}

std::optional<LoadError> ObjParser::readFace(const std::vector<std::string_view>& words) {
    if (words.size() < 4) {
        return failure("a face needs at least three corners");
    }
    faces_.push_back({corners_.size(), words.size() - 1, line_});
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string_view word = words[i];
        const std::size_t first = word.find('/');
        const std::size_t second =
            first == std::string_view::npos ? first : word.find('/', first + 1);
        Corner corner;
        const std::optional<std::int64_t> position =
            resolve(word.substr(0, first), positions_.size());
        std::optional<std::int64_t> normal = noIndex;
        if (second != std::string_view::npos) {
            normal = resolve(word.substr(second + 1), normals_.size());
        }
        if (!position || !normal) {
            return failure("'" + std::string(word) + "' is not a corner of a face");
        }
        corner.position = *position;
        corner.normal = *normal;
        corners_.push_back(corner);
    }
    return std::nullopt;
}

std::optional<LoadError> ObjParser::checkFaces() const {
    const auto positionCount = static_cast<std::int64_t>(positions_.size());
    const auto normalCount = static_cast<std::int64_t>(normals_.size());
    for (const Face& face : faces_) {
        for (std::size_t i = 0; i < face.cornerCount; ++i) {
            const Corner& corner = corners_[face.firstCorner + i];
            if (corner.position >= positionCount) {
                return failure("index " + std::to_string(corner.position + 1) + " names none of " +
                                   std::to_string(positionCount) + " positions",
                               face.line);
            }
            if (corner.normal >= normalCount) {
                return failure("index " + std::to_string(corner.normal + 1) + " names none of " +
                                   std::to_string(normalCount) + " normals",
                               face.line);
            }
        }
    }
    return std::nullopt;
}

ModelMesh ObjParser::assemble() const {
    bool withNormals = !corners_.empty();
    for (const Corner& corner : corners_) {
        withNormals = withNormals && corner.normal != noIndex &&
                      glm::length(normals_[static_cast<std::size_t>(corner.normal)]) > 0.0F;
    }
    ModelMesh mesh;
    mesh.name = file_.stem().string();
    std::map<std::pair<std::int64_t, std::int64_t>, std::uint32_t> known;
    const auto vertex = [&](const Corner& corner) {
        const auto [entry, added] =
            known.try_emplace({corner.position, withNormals ? corner.normal : noIndex},
                              static_cast<std::uint32_t>(mesh.positions.size()));
        if (added) {
            mesh.positions.push_back(positions_[static_cast<std::size_t>(corner.position)]);
            if (withNormals) {
                mesh.normals.push_back(
                    glm::normalize(normals_[static_cast<std::size_t>(corner.normal)]));
            }
        }
        return entry->second;
    };
    for (const Face& face : faces_) {
        for (std::size_t i = 1; i + 1 < face.cornerCount; ++i) {
            for (const std::size_t corner : {std::size_t{0}, i, i + 1}) {
                mesh.indices.push_back(vertex(corners_[face.firstCorner + corner]));
            }
        }
    }
    return mesh;
}

} // namespace

Result<Model, LoadError> readObj(std::string_view text, const std::filesystem::path& file) {
    return ObjParser(file).parse(text);
}

} // namespace aolib
