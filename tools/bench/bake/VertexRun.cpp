#include "bench/bake/VertexRun.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <map>
#include <memory>

#include <glm/geometric.hpp>

#include "bench/CsvLine.h"

namespace aolib::bench {

namespace {

constexpr std::array<VertexMethod, 8> ways{{
    {BakeMethodName::Rays, bake::VertexFit::Direct},
    {BakeMethodName::Rays, bake::VertexFit::TriangleMean},
    {BakeMethodName::Rays, bake::VertexFit::LeastSquares},
    {BakeMethodName::Scatter, bake::VertexFit::Direct},
    {BakeMethodName::Scatter, bake::VertexFit::LeastSquares},
    {BakeMethodName::Shadow, bake::VertexFit::Direct},
    {BakeMethodName::Shadow, bake::VertexFit::TriangleMean},
    {BakeMethodName::Shadow, bake::VertexFit::LeastSquares},
}};

/// The truth's rays are not those that are measured.
constexpr std::uint32_t vertexTruthSeed = 1;

/// Cuts one surface's triangles.
class Cutter {
public:
    explicit Cutter(const bake::Surface& surface) : cut_(surface) {
        cut_.indices.clear();
        for (std::size_t i = 0; i + 2 < surface.indices.size(); i += 3) {
            const std::uint32_t a = surface.indices[i];
            const std::uint32_t b = surface.indices[i + 1];
            const std::uint32_t c = surface.indices[i + 2];
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            for (const std::uint32_t index : {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca}) {
                cut_.indices.push_back(index);
            }
        }
    }
    bake::Surface takeSurface() { return std::move(cut_); }
    std::vector<std::pair<std::uint32_t, std::uint32_t>> takeEnds() { return std::move(ends_); }

private:
    std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
        const auto ends = std::minmax(a, b);
        const auto next = static_cast<std::uint32_t>(cut_.positions.size());
        const auto [found, fresh] = known_.try_emplace(ends, next);
        if (fresh) {
            ends_.emplace_back(ends);
            cut_.positions.push_back(0.5F * (cut_.positions[a] + cut_.positions[b]));
            if (!cut_.normals.empty()) {
                const glm::vec3 sum = cut_.normals[a] + cut_.normals[b];
                const float length = glm::length(sum);
                cut_.normals.push_back(length > 0.0F ? sum / length : glm::vec3(0.0F));
            }
            if (!cut_.uvs.empty()) {
                cut_.uvs.push_back(0.5F * (cut_.uvs[a] + cut_.uvs[b]));
            }
        }
        return found->second;
    }

    bake::Surface cut_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> known_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_;
};

double areaOf(const bake::Surface& surface, std::size_t first) {
    const glm::dvec3 a(surface.positions[surface.indices[first]]);
    return 0.5 *
           glm::length(glm::cross(glm::dvec3(surface.positions[surface.indices[first + 1]]) - a,
                                  glm::dvec3(surface.positions[surface.indices[first + 2]]) - a));
}

/// Squared differences with their weights.
struct Squares {
    double sum = 0.0;
    double weight = 0.0;

    void add(double difference, double share) {
        sum += difference * difference * share;
        weight += share;
    }
    double root() const { return weight > 0.0 ? std::sqrt(sum / weight) : 0.0; }
};

Result<std::vector<bake::BakedVertices>>
verticesOf(const Result<std::unique_ptr<bake::AbstractBaker>>& baker, bake::VertexFit fit) {
    if (!baker) {
        return baker.status();
    }
    bake::VertexOptions options;
    options.fit = fit;
    return (*baker)->bakeVertices(options, {});
}

Result<VertexRow> measuredVertices(const BakeMesh& mesh, const CutMesh& cut, int samples,
                                   const VertexMethod& how,
                                   const std::vector<bake::BakedVertices>& truth,
                                   const ProcAddressLoader& loader) {
    VertexRow row{mesh.name, 0, how, samples, 0.0, 0.0, 0.0};
    const auto baker = bakerOf(mesh, how.method, samples, loader);
    const std::clock_t used = std::clock();
    const auto values = verticesOf(baker, how.fit);
    if (!values) {
        return values.status();
    }
    row.processor = double(std::clock() - used) / CLOCKS_PER_SEC;
    compareVertices(mesh.scene, cut, *values, truth, row);
    return row;
}

std::string rounded(double value, int decimals) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    return text.data();
}

} // namespace

const char* vertexFitName(bake::VertexFit fit) {
    switch (fit) {
    case bake::VertexFit::Direct:
        return "direct";
    case bake::VertexFit::TriangleMean:
        return "triangle-mean";
    case bake::VertexFit::LeastSquares:
        return "least-squares";
    }
    return "unknown";
}

CutMesh cutInFour(const bake::BakeScene& scene) {
    CutMesh cut;
    cut.scene = scene;
    for (bake::Surface& surface : cut.scene.surfaces) {
        Cutter cutter(surface);
        surface = cutter.takeSurface();
        cut.ends.push_back(cutter.takeEnds());
    }
    return cut;
}

void compareVertices(const bake::BakeScene& scene, const CutMesh& cut,
                     const std::vector<bake::BakedVertices>& values,
                     const std::vector<bake::BakedVertices>& truth, VertexRow& row) {
    Squares atVertices;
    Squares onSurface;
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
        const bake::Surface& surface = scene.surfaces[s];
        const bake::Surface& finer = cut.scene.surfaces[s];
        if (surface.map < 0) {
            continue;
        }
        const std::size_t count = surface.positions.size();
        std::vector<double> areas(finer.positions.size(), 0.0);
        for (std::size_t i = 0; i + 2 < finer.indices.size(); i += 3) {
            for (std::size_t k = 0; k < 3; ++k) {
                areas[finer.indices[i + k]] += areaOf(finer, i);
            }
        }
        for (std::size_t v = 0; v < finer.positions.size(); ++v) {
            const double right{truth[s].visibility[v]};
            if (areas[v] <= 0.0) {
                continue;
            }
            if (v < count) {
                atVertices.add(double{values[s].visibility[v]} - right, 1.0);
                continue;
            }
            const auto [a, b] = cut.ends[s][v - count];
            const double between =
                0.5 * (double{values[s].visibility[a]} + double{values[s].visibility[b]});
            onSurface.add(between - right, areas[v]);
        }
    }
    row.vertices = static_cast<std::size_t>(atVertices.weight);
    row.atVertices = atVertices.root();
    row.onSurface = onSurface.root();
}

Result<std::vector<VertexRow>>
runVertexPlan(const BakePlan& plan, const ProcAddressLoader& loader,
              const std::function<bool(const std::string& next, double done)>& tell) {
    std::vector<VertexRow> rows;
    std::size_t done = 0;
    const std::size_t cells = plan.meshes.size() * (plan.samples.size() * ways.size() + 1);
    const auto goOn = [&](const std::string& next) {
        return tell(next, double(done++) / double(cells));
    };
    for (const BakeMesh& mesh : plan.meshes) {
        if (!goOn(mesh.name + ", truth")) {
            return rows;
        }
        const CutMesh cut = cutInFour(mesh.scene);
        bake::RayOptions rays;
        rays.rays = plan.truthRays;
        rays.seed = vertexTruthSeed;
        const auto truth =
            verticesOf(bake::createRayBaker(cut.scene, rays), bake::VertexFit::Direct);
        if (!truth) {
            return AoStatus(truth.status().code(), mesh.name + ": " + truth.status().message());
        }
        for (const int samples : plan.samples) {
            for (const VertexMethod& how : ways) {
                const std::string what =
                    mesh.name + ", " + bakeMethodName(how.method) + ", " + vertexFitName(how.fit);
                if (!goOn(what)) {
                    return rows;
                }
                const Result<VertexRow> row =
                    measuredVertices(mesh, cut, samples, how, *truth, loader);
                if (!row) {
                    return AoStatus(row.status().code(), what + ": " + row.status().message());
                }
                rows.push_back(*row);
            }
        }
    }
    return rows;
}

std::string vertexCsv(const std::vector<VertexRow>& rows) {
    std::string text = "mesh,vertices,method,fit,samples,processor_seconds,rmse_at_vertices,"
                       "rmse_on_surface\n";
    for (const VertexRow& row : rows) {
        text += CsvLine()
                    .add(row.mesh)
                    .add(row.vertices)
                    .add(bakeMethodName(row.how.method))
                    .add(vertexFitName(row.how.fit))
                    .add(row.samples)
                    .add(row.processor)
                    .add(row.atVertices)
                    .add(row.onSurface)
                    .text();
    }
    return text;
}

std::string vertexMarkdown(const std::vector<VertexRow>& rows) {
    std::string text = "| mesh | vertices | method | fit | samples | processor time | "
                       "RMSE at vertices | RMSE on the surface |\n"
                       "|---|---|---|---|---|---|---|---|\n";
    for (const VertexRow& row : rows) {
        text += "| " + row.mesh + " | " + std::to_string(row.vertices) + " | " +
                bakeMethodName(row.how.method) + " | " + vertexFitName(row.how.fit) + " | " +
                std::to_string(row.samples) + " | " + rounded(row.processor, 1) + " s | " +
                rounded(row.atVertices, 4) + " | " + rounded(row.onSurface, 4) + " |\n";
    }
    return text;
}

} // namespace aolib::bench
