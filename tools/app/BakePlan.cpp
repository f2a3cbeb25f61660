#include "app/BakePlan.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <aolib/bake/Atlas.h>

namespace aolib::app {

namespace {

/// Texels between charts of our own: bilinear filters over a few mipmap levels keep apart. Fewer
/// where so many charts leave no room.
constexpr int kChartGaps[] = {8, 4, 2, 1};

class Planner {
public:
    Planner(BakeInput& input, const BakeFlags& flags) : input_(input), flags_(flags) {}

    Result<std::vector<PlannedMap>, Failure> plan() {
        std::vector<PlannedMap> maps = groups();
        for (std::size_t number = 0; number < maps.size(); ++number) {
            PlannedMap& map = maps[number];
            for (const std::size_t i : map.pieces) {
                input_.pieces[i].surface.map = static_cast<int>(number);
            }
            if (takeGivenUvs(map, static_cast<int>(number))) {
                continue;
            }
            if (flags_.unwrap == Unwrap::Never) {
                return badInput(input_.name + ", " + map.name +
                                ": its UVs are not fit for a map: " + map.given.sentence() +
                                "; --unwrap auto makes others");
            }
            if (MaybeFailure failure = unwrap(map)) {
                return *failure;
            }
        }
        return maps;
    }

private:
    std::vector<PlannedMap> groups();
    bool takeGivenUvs(PlannedMap& map, int number);
    void takeSet(const PlannedMap& map, int set);
    MaybeFailure unwrap(PlannedMap& map);
    MaybeFailure split(BakePiece& piece, const bake::UnwrappedSurface& unwrapped, int uvSet);

    BakeInput& input_;
    const BakeFlags& flags_;
};

/// Pieces by material, in the order of their first appearance. Those without get a new one.
std::vector<PlannedMap> Planner::groups() {
    std::vector<PlannedMap> maps;
    std::map<int, std::size_t> known;
    for (std::size_t i = 0; i < input_.pieces.size(); ++i) {
        const int material = input_.pieces[i].origin.material;
        const auto [found, fresh] = known.try_emplace(material, maps.size());
        if (fresh) {
            PlannedMap map;
            map.material = material >= 0 ? material : input_.edit.addMaterial("occlusion");
            map.name = input_.edit.materialName(map.material);
            maps.push_back(std::move(map));
        }
        PlannedMap& map = maps[found->second];
        map.pieces.push_back(i);
        if (material < 0) {
            const GltfOrigin& origin = input_.pieces[i].origin;
            input_.edit.setMaterial(origin.mesh, origin.primitive, map.material);
        }
    }
    return maps;
}

void Planner::takeSet(const PlannedMap& map, int set) {
    for (const std::size_t i : map.pieces) {
        BakePiece& piece = input_.pieces[i];
        const auto number = static_cast<std::size_t>(set);
        piece.surface.uvs =
            number < piece.uvSets.size() ? piece.uvSets[number] : std::vector<glm::vec2>();
    }
}

/// Takes the first of the model's UV sets that is fit, the one of its occlusion texture first.
bool Planner::takeGivenUvs(PlannedMap& map, int number) {
    std::size_t sets = 1;
    for (const std::size_t i : map.pieces) {
        sets = std::max(sets, input_.pieces[i].uvSets.size());
    }
    std::vector<int> order;
    if (flags_.uvSet >= 0) {
        order.push_back(flags_.uvSet);
    } else {
        const int used = input_.edit.occlusionUvSet(map.material);
        if (used >= 0) {
            order.push_back(used);
        }
        for (int set = 0; set < static_cast<int>(sets); ++set) {
            if (set != used) {
                order.push_back(set);
            }
        }
    }
    bake::BakeScene scene;
    for (const std::size_t i : map.pieces) {
        scene.surfaces.push_back(input_.pieces[i].surface);
    }
    for (std::size_t k = 0; k < order.size(); ++k) {
        takeSet(map, order[k]);
        for (std::size_t j = 0; j < map.pieces.size(); ++j) {
            scene.surfaces[j].uvs = input_.pieces[map.pieces[j]].surface.uvs;
        }
        const bake::UvReport report =
            bake::checkUvs(scene, number, flags_.map.width, flags_.map.height);
        if (k == 0) {
            map.given = report;
        }
        if (report.good()) {
            map.given = report;
            map.uvSet = order[k];
            return flags_.unwrap != Unwrap::Always;
        }
    }
    return false;
}

MaybeFailure Planner::unwrap(PlannedMap& map) {
    std::vector<const bake::Surface*> surfaces;
    map.uvSet = 0;
    for (const std::size_t i : map.pieces) {
        const BakePiece& piece = input_.pieces[i];
        surfaces.push_back(&piece.surface);
        map.uvSet = std::max(map.uvSet, static_cast<int>(piece.uvSets.size()));
    }
    Result<bake::Atlas> atlas = AoStatus();
    for (const int gap : kChartGaps) {
        atlas = bake::makeAtlas(surfaces, flags_.map.width, flags_.map.height, gap);
        if (atlas || atlas.status().code() != StatusCode::InvalidOption) {
            break;
        }
    }
    if (!atlas) {
        return badInput(input_.name + ", " + map.name + ": " + atlas.status().message() +
                        "; --size sets a larger one");
    }
    map.charts = atlas->charts;
    for (std::size_t k = 0; k < map.pieces.size(); ++k) {
        BakePiece& piece = input_.pieces[map.pieces[k]];
        if (MaybeFailure failure = split(piece, atlas->surfaces[k], map.uvSet)) {
            return failure;
        }
        piece.surface = bake::withAtlas(piece.surface, atlas->surfaces[k]);
    }
    return std::nullopt;
}

/// Gives the piece's primitive the vertices of the atlas and its UVs; sets that are missing before
/// it get the same, since they must be numbered without gaps.
MaybeFailure Planner::split(BakePiece& piece, const bake::UnwrappedSurface& unwrapped, int uvSet) {
    const int mesh = input_.edit.ownMesh(piece.origin.node);
    for (BakePiece& other : input_.pieces) {
        if (other.origin.node == piece.origin.node) {
            other.origin.mesh = mesh;
        }
    }
    std::vector<std::uint32_t> indices = unwrapped.indices;
    for (std::size_t i = 0; piece.mirrored && i + 2 < indices.size(); i += 3) {
        std::swap(indices[i + 1], indices[i + 2]);
    }
    if (const std::optional<LoadError> error =
            input_.edit.splitVertices(mesh, piece.origin.primitive, unwrapped.source, indices)) {
        return badInput(error->sentence);
    }
    std::vector<float> values;
    for (const glm::vec2& uv : unwrapped.uvs) {
        values.push_back(uv.x);
        values.push_back(1.0F - uv.y);
    }
    const int accessor = input_.edit.addFloats(values, 2);
    for (int set = input_.edit.uvSets(mesh, piece.origin.primitive); set <= uvSet; ++set) {
        input_.edit.setAttribute(mesh, piece.origin.primitive, "TEXCOORD_" + std::to_string(set),
                                 accessor);
    }
    return std::nullopt;
}

} // namespace

Result<std::vector<PlannedMap>, Failure> planMaps(BakeInput& input, const BakeFlags& flags) {
    return Planner(input, flags).plan();
}

} // namespace aolib::app
