#include "app/BakeJob.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <aolib/bake/AbstractBaker.h>

#include "app/BakeInput.h"
#include "app/BakePlan.h"
#include "app/Interruption.h"
#include "app/OutputFiles.h"
#include "app/Table.h"
#include "image/Pfm.h"
#include "image/Png16.h"

namespace aolib::app {

namespace {

Failure failureOf(const std::string& subject, const Status& status) {
    if (status.code() == StatusCode::Cancelled) {
        return {ExitCode::Failed, "cancelled; nothing was written for " + subject};
    }
    switch (status.code()) {
    case StatusCode::OutOfMemory:
        return {ExitCode::Failed, subject + ": " + status.message()};
    case StatusCode::ShaderError:
    case StatusCode::NoContext:
        return graphicsFailure(subject + ": " + status.message());
    default:
        return badInput(subject + ": " + status.message());
    }
}

/// The PNG of values in [0,1], channels interleaved.
std::vector<std::uint8_t> pngOf(const std::vector<float>& values, int width, int height,
                                int channels, int bits) {
    const auto fill = [&](auto& image, float most) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            image.pixels[i] = static_cast<std::remove_reference_t<decltype(image.pixels[0])>>(
                std::lround(std::clamp(values[i], 0.0F, 1.0F) * most));
        }
        return encodedPng(image);
    };
    if (bits == 16) {
        WordImage image(width, height, channels);
        return fill(image, 65535.0F);
    }
    ByteImage image(width, height, channels);
    return fill(image, 255.0F);
}

std::vector<float> greyOf(const bake::BakedMap& map) {
    std::vector<float> values = map.visibility;
    std::replace_if(
        values.begin(), values.end(), [](float w) { return w < 0.0F; }, 0.0F);
    return values;
}

std::vector<float> componentsOf(const std::vector<glm::vec3>& vectors) {
    std::vector<float> values;
    values.reserve(vectors.size() * 3);
    for (const glm::vec3& v : vectors) {
        values.insert(values.end(), {v.x, v.y, v.z});
    }
    return values;
}

/// "map.png", or "map-NAME.png" where there are several.
std::filesystem::path mapFile(const std::string& file, const std::vector<PlannedMap>& maps,
                              std::size_t number) {
    std::filesystem::path path(file);
    if (maps.size() == 1) {
        return path;
    }
    std::string name;
    for (const char c : maps[number].name) {
        name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    const auto same = std::count_if(maps.begin(), maps.end(), [&](const PlannedMap& other) {
        return other.name == maps[number].name;
    });
    const std::string tail = "-" + name + (same > 1 ? "-" + std::to_string(number) : "");
    return path.parent_path() / (path.stem().string() + tail + path.extension().string());
}

class Job {
public:
    Job(BakeInput input, const BakeFlags& flags, std::string out, Progress& progress)
        : input_(std::move(input)), flags_(flags), out_(std::move(out)), progress_(progress) {}

    Outcome<std::string> run() {
        return flags_.target == BakeTarget::Texture ? bakeMaps() : bakeVertices();
    }

private:
    Outcome<std::string> bakeMaps();
    Outcome<std::string> bakeVertices();
    Outcome<std::unique_ptr<bake::AbstractBaker>> baker();
    bake::BakeScene scene() const;
    bake::BakeProgress callback() const;
    MaybeFailure putMap(OutputFiles& files, const std::filesystem::path& file, bool normals,
                        const bake::BakedMap& map) const;
    MaybeFailure putModel(OutputFiles& files);
    MaybeFailure setVertices(const BakePiece& piece, const bake::BakedVertices& vertices);
    MaybeFailure commit(OutputFiles& files) const;

    BakeInput input_;
    std::optional<GlSession> session_; ///< outlives bakers
    const BakeFlags& flags_;
    std::string out_;
    Progress& progress_;
};

bake::BakeScene Job::scene() const {
    bake::BakeScene scene;
    for (const BakePiece& piece : input_.pieces) {
        scene.surfaces.push_back(piece.surface);
    }
    if (flags_.ground) {
        scene.ground =
            flags_.groundHeight ? static_cast<float>(*flags_.groundHeight) : input_.bounds.min.y;
    }
    return scene;
}

Outcome<std::unique_ptr<bake::AbstractBaker>> Job::baker() {
    Result<std::unique_ptr<bake::AbstractBaker>> made = Status();
    const double radius = flags_.radius.resolved(double{input_.bounds.diagonal()});
    if (flags_.method == BakeMethod::Rays) {
        bake::RayOptions rays = flags_.rays;
        rays.radius = static_cast<float>(radius);
        made = bake::createRayBaker(scene(), rays);
    } else {
        if (radius > 0.0) {
            return badInput("--radius: pictures from the light know no distance between occluder "
                            "and receiver; --method rays does");
        }
        Outcome<GlSession> session = GlSession::open(flags_.gl);
        if (!session) {
            return session.failure();
        }
        session_.emplace(std::move(*session));
        bake::ScatterOptions scatter = flags_.scatter;
        bake::ShadowOptions shadow = flags_.shadow;
        scatter.sky = shadow.sky = flags_.rays.sky;
        scatter.seed = shadow.seed = flags_.rays.seed;
        made = flags_.method == BakeMethod::Scatter
                   ? bake::createScatterBaker(session_->loader(), scene(), scatter)
                   : bake::createShadowBaker(session_->loader(), scene(), shadow);
    }
    if (!made) {
        return failureOf(input_.name, made.status());
    }
    return std::move(*made);
}

bake::BakeProgress Job::callback() const {
    return [this](double fraction) {
        progress_.update(fraction);
        return !Interruption::happened();
    };
}

MaybeFailure Job::putMap(OutputFiles& files, const std::filesystem::path& file, bool normals,
                         const bake::BakedMap& map) const {
    if (MaybeFailure failure =
            files.announce(normals ? "--bent-normals" : "--ao", file, {".png", ".pfm"})) {
        return failure;
    }
    std::vector<float> values = normals ? componentsOf(map.bentNormal) : map.visibility;
    if (file.extension() == ".pfm") {
        FloatImage image(map.width, map.height, normals ? 3 : 1);
        image.pixels = std::move(values);
        files.put(file, std::move(image));
        return std::nullopt;
    }
    if (normals) {
        std::transform(values.begin(), values.end(), values.begin(),
                       [](float v) { return 0.5F * v + 0.5F; });
    }
    files.put(file, pngOf(normals ? values : greyOf(map), map.width, map.height, normals ? 3 : 1,
                          flags_.bits));
    return std::nullopt;
}

MaybeFailure Job::putModel(OutputFiles& files) {
    if (out_.empty()) {
        return std::nullopt;
    }
    const Loaded<std::string> glb = input_.edit.glb();
    if (!glb) {
        return Failure{ExitCode::Failed, glb.sentence()};
    }
    files.put(out_, std::vector<std::uint8_t>(glb->begin(), glb->end()));
    return std::nullopt;
}

MaybeFailure Job::commit(OutputFiles& files) const {
    if (session_) {
        if (MaybeFailure failure = session_->reviewMessages()) {
            return failure;
        }
    }
    if (Interruption::happened()) {
        return failureOf(input_.name, {StatusCode::Cancelled, ""});
    }
    return files.commit();
}

Outcome<std::string> Job::bakeMaps() {
    progress_.begin(input_.name + ": looking at its UVs");
    const Outcome<std::vector<PlannedMap>> maps = planMaps(input_, flags_);
    if (!maps) {
        return maps.failure();
    }
    OutputFiles files;
    if (!out_.empty()) {
        if (MaybeFailure failure = files.announce("--out", out_, {".glb"})) {
            return *failure;
        }
    }
    progress_.begin(input_.name + ": baking");
    const auto made = baker();
    if (!made) {
        return made.failure();
    }
    const auto baked = (*made)->bakeMaps(flags_.map, callback());
    if (!baked) {
        return failureOf(input_.name, baked.status());
    }
    progress_.begin(input_.name + ": writing");
    Table table({"map", "triangles", "texels", "shared", "charts", "mean W"});
    std::vector<std::string> remarks{"UVs"};
    for (std::size_t i = 0; i < maps->size(); ++i) {
        const PlannedMap& plan = (*maps)[i];
        const bake::BakedMap& map = (*baked)[i];
        input_.edit.setOcclusionTexture(plan.material,
                                        pngOf(greyOf(map), map.width, map.height, 1, flags_.bits),
                                        plan.uvSet, plan.name + " occlusion");
        for (const bool normals : {false, true}) {
            const std::string& file = normals ? flags_.bentNormals : flags_.ao;
            if (!file.empty()) {
                if (MaybeFailure failure = putMap(files, mapFile(file, *maps, i), normals, map)) {
                    return *failure;
                }
            }
        }
        double sum = 0.0;
        std::size_t covered = 0;
        for (std::size_t t = 0; t < map.kind.size(); ++t) {
            if (map.kind[t] == bake::TexelKind::Inside) {
                sum += double(map.visibility[t]);
                ++covered;
            }
        }
        char shared[32] = {};
        std::snprintf(shared, sizeof(shared), "%.2g%%", 100.0 * plan.given.overlap());
        table.add({plan.name, grouped(plan.given.triangles), grouped(covered), shared,
                   plan.charts > 0 ? grouped(plan.charts) : "-",
                   knownNumber(covered > 0 ? sum / double(covered) : -1.0, 3)});
        remarks.push_back("TEXCOORD_" + std::to_string(plan.uvSet) +
                          (plan.charts > 0 ? ", our own: " + plan.given.sentence() : ""));
    }
    if (MaybeFailure failure = putModel(files)) {
        return *failure;
    }
    if (MaybeFailure failure = commit(files)) {
        return *failure;
    }
    return table.text(remarks);
}

/// The piece's values as attributes of its primitive.
MaybeFailure Job::setVertices(const BakePiece& piece, const bake::BakedVertices& vertices) {
    const int mesh = input_.edit.ownMesh(piece.origin.node);
    for (BakePiece& other : input_.pieces) {
        if (other.origin.node == piece.origin.node) {
            other.origin.mesh = mesh;
        }
    }
    const int primitive = piece.origin.primitive;
    if (flags_.attribute == VertexAttribute::Color) {
        if (input_.edit.attribute(mesh, primitive, "COLOR_0") >= 0) {
            return badInput(input_.name + ": " + piece.name +
                            " has vertex colours already; --attribute ao keeps them");
        }
        std::vector<float> colours;
        for (const float w : vertices.visibility) {
            colours.insert(colours.end(), {w, w, w});
        }
        input_.edit.setAttribute(mesh, primitive, "COLOR_0", input_.edit.addFloats(colours, 3));
        return std::nullopt;
    }
    // As normals are: the inverse transpose takes them to the world.
    const glm::mat3 toMesh = glm::transpose(glm::mat3(piece.transform));
    std::vector<glm::vec3> normals;
    for (const glm::vec3& world : vertices.bentNormal) {
        const glm::vec3 local = toMesh * world;
        const float length = glm::length(local);
        normals.push_back(length > 0.0F ? local / length : glm::vec3(0.0F, 1.0F, 0.0F));
    }
    input_.edit.setAttribute(mesh, primitive, "_AO", input_.edit.addFloats(vertices.visibility, 1));
    input_.edit.setAttribute(mesh, primitive, "_BENT_NORMAL",
                             input_.edit.addFloats(componentsOf(normals), 3));
    return std::nullopt;
}

Outcome<std::string> Job::bakeVertices() {
    OutputFiles files;
    if (!flags_.ao.empty() || !flags_.bentNormals.empty() || out_.empty()) {
        return badInput("--target vertex writes a model with -o, and neither --ao nor "
                        "--bent-normals");
    }
    if (MaybeFailure failure = files.announce("--out", out_, {".glb"})) {
        return *failure;
    }
    progress_.begin(input_.name + ": baking");
    const auto made = baker();
    if (!made) {
        return made.failure();
    }
    const auto baked = (*made)->bakeVertices(flags_.vertices, callback());
    if (!baked) {
        return failureOf(input_.name, baked.status());
    }
    progress_.begin(input_.name + ": writing");
    Table table({"piece", "triangles", "vertices", "mean W"});
    for (std::size_t i = 0; i < input_.pieces.size(); ++i) {
        const bake::BakedVertices& vertices = (*baked)[i];
        if (MaybeFailure failure = setVertices(input_.pieces[i], vertices)) {
            return *failure;
        }
        double sum = 0.0;
        for (const float w : vertices.visibility) {
            sum += double(w);
        }
        table.add({input_.pieces[i].name, grouped(input_.pieces[i].surface.indices.size() / 3),
                   grouped(vertices.visibility.size()),
                   knownNumber(sum / double(vertices.visibility.size()), 3)});
    }
    if (MaybeFailure failure = putModel(files)) {
        return *failure;
    }
    if (MaybeFailure failure = commit(files)) {
        return *failure;
    }
    return table.text();
}

} // namespace

Outcome<std::string> bakeModel(const std::string& input, const std::string& out,
                               const BakeFlags& flags, Progress& progress) {
    progress.begin("opening " + input);
    Outcome<BakeInput> opened = openBakeInput(input);
    if (!opened) {
        return opened.failure();
    }
    try {
        return Job(std::move(*opened), flags, out, progress).run();
    } catch (const std::bad_alloc&) {
        return Failure{ExitCode::Failed, input + ": no memory left; nothing was written"};
    } catch (const std::exception& error) {
        return badInput(input + ": cannot be edited (" + error.what() + ")");
    }
}

} // namespace aolib::app
