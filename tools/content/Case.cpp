#include "content/Case.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "content/FileBytes.h"
#include "content/SceneSource.h"
#include "content/generated/GeneratedScenes.h"

namespace aolib {
namespace {

using Json = nlohmann::ordered_json;

constexpr int largestSide = 16384;
constexpr float groundSize = 20.0F; ///< of the model's diagonal

constexpr std::array<std::string_view, 13> knownKeys{
    "mesh",  "eye",    "target", "up",      "fovy_deg", "near",  "far",
    "width", "height", "radius", "falloff", "normals",  "ground"};

struct FalloffName {
    const char* name;
    Falloff falloff;
};
constexpr std::array<FalloffName, 3> falloffNames{
    {{"step", Falloff::Step}, {"exp", Falloff::Exp}, {"none", Falloff::Off}}};

/// Reads members one by one and keeps the first thing that is wrong.
class CaseParser {
public:
    CaseParser(const Json& json, std::string name) : json_(json), name_(std::move(name)) {}

    Result<Case, LoadError> parse();

private:
    void fail(const std::string& reason) {
        if (!error_) {
            error_ = LoadError{name_ + ": " + reason};
        }
    }
    const Json* member(const char* key);
    std::string text(const char* key);
    float number(const char* key);
    float number(const Json& value, const std::string& key);
    int pixels(const char* key);
    glm::vec3 vector(const char* key);
    void readChoices(Case& scene);
    void checkRanges(const Case& scene);

    const Json& json_;
    std::string name_;
    std::optional<LoadError> error_;
};

const Json* CaseParser::member(const char* key) {
    const auto found = json_.find(key);
    if (found == json_.end()) {
        fail("'" + std::string(key) + "' is missing");
        return nullptr;
    }
    return &*found;
}

std::string CaseParser::text(const char* key) {
    const Json* value = member(key);
    if (value == nullptr) {
        return {};
    }
    if (!value->is_string() || value->get_ref<const std::string&>().empty()) {
        fail("'" + std::string(key) + "' is not a text");
        return {};
    }
    return value->get<std::string>();
}

float CaseParser::number(const Json& value, const std::string& key) {
    const auto result = value.is_number() ? static_cast<float>(value.get<double>()) : NAN;
    if (!std::isfinite(result)) {
        fail("'" + key + "' is not a finite number");
        return 0.0F;
    }
    return result;
}

float CaseParser::number(const char* key) {
    const Json* value = member(key);
    return value == nullptr ? 0.0F : number(*value, key);
}

int CaseParser::pixels(const char* key) {
    const Json* value = member(key);
    if (value == nullptr) {
        return 0;
    }
    if (!value->is_number_integer() || *value < 1 || *value > largestSide) {
        fail("'" + std::string(key) + "' is not a whole number from 1 to " +
             std::to_string(largestSide));
        return 0;
    }
    return value->get<int>();
}

glm::vec3 CaseParser::vector(const char* key) {
    const Json* value = member(key);
    glm::vec3 result{0.0F};
    if (value == nullptr) {
        return result;
    }
    if (!value->is_array() || value->size() != 3) {
        fail("'" + std::string(key) + "' is not a list of three numbers");
        return result;
    }
    for (int axis = 0; axis < 3; ++axis) {
        result[axis] = number((*value)[static_cast<std::size_t>(axis)], key);
    }
    return result;
}

void CaseParser::readChoices(Case& scene) {
    const std::string falloff = text("falloff");
    const auto* known = std::find_if(falloffNames.begin(), falloffNames.end(),
                                     [&](const FalloffName& f) { return falloff == f.name; });
    if (known == falloffNames.end()) {
        fail("'falloff' is '" + falloff + "', not step, exp or none");
    } else {
        scene.falloff = known->falloff;
    }
    const std::string normals = text("normals");
    if (normals != "geometric" && normals != "given") {
        fail("'normals' is '" + normals + "', not geometric or given");
    }
    scene.normals = normals == "given" ? CaseNormals::Given : CaseNormals::Geometric;
}

void CaseParser::checkRanges(const Case& scene) {
    if (!(scene.fovyDeg > 0.0F && scene.fovyDeg < 180.0F)) {
        fail("'fovy_deg' is not between 0 and 180");
    }
    if (!(scene.near > 0.0F)) {
        fail("'near' is not above 0");
    }
    if (!(scene.far > scene.near)) {
        fail("'far' is not above 'near'");
    }
    if (!(scene.radius > 0.0F)) {
        fail("'radius' is not above 0");
    }
    const glm::dvec3 view = glm::dvec3(scene.target) - glm::dvec3(scene.eye);
    const glm::dvec3 up(scene.up);
    if (!(glm::length(view) > 0.0)) {
        fail("'eye' and 'target' are the same point");
    }
    if (!(glm::length(glm::cross(view, up)) > 1e-6 * glm::length(view) * glm::length(up))) {
        fail("'up' is parallel to the view");
    }
}

Result<Case, LoadError> CaseParser::parse() {
    if (!json_.is_object()) {
        return LoadError{name_ + ": a case is a JSON object"};
    }
    for (const auto& [key, value] : json_.items()) {
        if (std::find(knownKeys.begin(), knownKeys.end(), key) == knownKeys.end()) {
            fail("'" + key + "' is not a key of a case");
        }
    }
    Case scene;
    scene.mesh = text("mesh");
    scene.eye = vector("eye");
    scene.target = vector("target");
    scene.up = vector("up");
    scene.fovyDeg = number("fovy_deg");
    scene.near = number("near");
    scene.far = number("far");
    scene.width = pixels("width");
    scene.height = pixels("height");
    scene.radius = number("radius");
    readChoices(scene);
    if (json_.contains("ground")) {
        scene.ground = number("ground");
    }
    checkRanges(scene);
    if (error_) {
        return *error_;
    }
    return scene;
}

/// The double whose shortest decimal is also the float's.
double shortest(float value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    double result = 0.0;
    std::from_chars(digits.data(), end, result);
    return result;
}

Json list(const glm::vec3& v) {
    return Json::array({shortest(v.x), shortest(v.y), shortest(v.z)});
}

} // namespace

Result<Case, LoadError> parseCase(std::string_view json, const std::filesystem::path& file) {
    try {
        const Json parsed = Json::parse(json.begin(), json.end());
        Result<Case, LoadError> scene = CaseParser(parsed, file.string()).parse();
        if (scene) {
            scene->folder = file.parent_path();
        }
        return scene;
    } catch (const Json::parse_error& error) {
        return LoadError{file.string() + ": not valid JSON near byte " +
                         std::to_string(error.byte)};
    } catch (const Json::exception& error) {
        return LoadError{file.string() + ": cannot be read (" + error.what() + ")"};
    }
}

Result<Case, LoadError> readCase(const std::filesystem::path& file) {
    const Result<std::string, LoadError> bytes = readFileBytes(file);
    if (!bytes) {
        return bytes.error();
    }
    return parseCase(*bytes, file);
}

std::string writeCase(const Case& scene) {
    Json json;
    json["mesh"] = scene.mesh;
    json["eye"] = list(scene.eye);
    json["target"] = list(scene.target);
    json["up"] = list(scene.up);
    json["fovy_deg"] = shortest(scene.fovyDeg);
    json["near"] = shortest(scene.near);
    json["far"] = shortest(scene.far);
    json["width"] = scene.width;
    json["height"] = scene.height;
    json["radius"] = shortest(scene.radius);
    for (const FalloffName& known : falloffNames) {
        if (known.falloff == scene.falloff) {
            json["falloff"] = known.name;
        }
    }
    json["normals"] = scene.normals == CaseNormals::Given ? "given" : "geometric";
    if (scene.ground) {
        json["ground"] = shortest(*scene.ground);
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

void addGround(Model& model, float y) {
    const Bounds bounds = model.bounds();
    const float half = 0.5F * groundSize * bounds.diagonal();
    const glm::vec3 c = bounds.center();
    ModelMesh mesh;
    mesh.name = "ground";
    mesh.positions = {{c.x - half, y, c.z + half},
                      {c.x + half, y, c.z + half},
                      {c.x + half, y, c.z - half},
                      {c.x - half, y, c.z - half}};
    mesh.normals.assign(4, glm::vec3(0.0F, 1.0F, 0.0F));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.baseColour = {0.6F, 0.6F, 0.6F, 1.0F};
    const bool withNormals = std::any_of(model.meshes.begin(), model.meshes.end(),
                                         [](const ModelMesh& m) { return !m.normals.empty(); });
    if (!withNormals) {
        mesh.normals.clear();
    }
    model.meshes.push_back(std::move(mesh));
}

Result<Model, LoadError> loadCaseModel(const Case& scene) {
    const bool generated = findGeneratedScene(scene.mesh) != nullptr;
    Result<Model, LoadError> model =
        openScene(generated ? scene.mesh : (scene.folder / scene.mesh).string());
    if (model && scene.ground) {
        addGround(*model, *scene.ground);
    }
    return model;
}

NamedCamera caseCamera(const Case& scene) {
    return {"case", scene.eye, scene.target, scene.up, scene.fovyDeg, scene.near, scene.far};
}

} // namespace aolib
