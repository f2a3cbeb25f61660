#include "bake/ScatterBaker.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "bake/BakeVertices.h"
#include "bake/ChartCoverage.h"
#include "bake/CheckOptions.h"
#include "bake/Facets.h"
#include "bake/MapFill.h"
#include "bake/MapLoop.h"
#include "bake/PointTarget.h"
#include "bake/PointWeights.h"
#include "bake/SurfaceSamples.h"
#include "bake/TexelDensity.h"
#include "gl/StateGuard.h"

namespace aolib::bake {

namespace {

/// Directions between two calls of the progress callback.
constexpr int directionsAtOnce = 4;
/// Places per texel from which coverage is summed.
constexpr int coveragePlaces = 128;
/// Stage 1's picture, when its size is derived: pixels along a texel that faces the light, where
/// charts are laid out more finely than in this share of the maps, along the direction in which
/// they are stretched most. Where texels are smaller yet, points are larger than they. Of fewer
/// pixels the noise shows, more cost time.
constexpr double pixelsAlongTexel = 1.25;
constexpr double finelyShown = 0.9;
constexpr int leastRaster = 128;
constexpr int largestRaster = 4096;

/// Whether points are drawn, or else added up here: a software rasteriser sets up and blends each
/// by itself, which takes ten times as long as reading its picture.
bool drawsPoints(PointSum sum, bool software) {
    return sum == PointSum::Blending || (sum == PointSum::Auto && !software);
}

/// Stage 2 on the processor.
class PictureAdder {
public:
    PictureAdder(std::span<const PointShape> shapes, const PointWeights& weights,
                 const MapStack& stack, const PointTarget& target)
        : shapes_(shapes), weights_(weights), stack_(stack), target_(target) {}

    /// Adds what a direction lights.
    /// @param picture  u, v, number of the triangle from 1, 0 for none.
    void add(const std::vector<glm::vec4>& picture, const LightView& view,
             std::vector<glm::vec4>& light) const {
        const glm::vec4 unit(glm::vec3(view.direction), 1.0F);
        const glm::vec2 size(stack_.mapSize);
        for (const glm::vec4& pixel : picture) {
            if (pixel.z == 0.0F) {
                continue;
            }
            const auto triangle = static_cast<std::size_t>(pixel.z) - 1;
            const PointShape& shape = shapes_[triangle];
            const int row = shape.map - stack_.first;
            if (shape.facet == 0.0F || row < 0 || row >= stack_.count) {
                continue;
            }
            const float weight = weights_.of(triangle, glm::vec2(pixel), view);
            if (weight > 0.0F) {
                const glm::vec2 place =
                    glm::vec2(pixel) * size + glm::vec2(0.0F, float(row) * size.y);
                target_.scatter(place, shape, [&](std::size_t texel, float share) {
                    light[texel] += unit * (share * weight);
                });
            }
        }
    }

private:
    std::span<const PointShape> shapes_;
    const PointWeights& weights_;
    const MapStack& stack_;
    const PointTarget& target_;
};

} // namespace

struct ScatterBaker::Sums {
    std::vector<glm::vec4> light;
    std::vector<float> coverage;
};

int ScatterBaker::rasterSize(const glm::ivec2& mapSize) const {
    if (options_.rasterSize > 0) {
        return std::min(options_.rasterSize, gpu_.gl->capabilities.maxTextureSize);
    }
    const double texels =
        texelsAlongUnit(gpu_.geometry, gpu_.frame, glm::dvec2(mapSize), finelyShown);
    const double size = pixelsAlongTexel * texels * double{ScatterPasses::pictureSide};
    return std::clamp((static_cast<int>(size) + 63) / 64 * 64, leastRaster,
                      std::min(largestRaster, gpu_.gl->capabilities.maxTextureSize));
}

/// Square texels per square frame unit, if all charts were stretched alike.
float ScatterBaker::density(const std::vector<TexelRaster>& rasters) const {
    double texels = 0.0;
    for (const TexelRaster& raster : rasters) {
        texels += static_cast<double>(raster.coveredTexels());
    }
    double area = 0.0;
    for (const SurfaceSample& sample : triangleCentres(gpu_.geometry)) {
        area += double{sample.area};
    }
    const double scale = gpu_.frame.scale();
    return static_cast<float>(texels / (area * scale * scale));
}

Result<ScatterPasses> ScatterBaker::passesFor(const ScatterPasses::Settings& settings,
                                              const std::vector<float>& facets) const {
    const gl::StateGuard guard(*gpu_.gl);
    return ScatterPasses::create(*gpu_.gl, settings, facets);
}

Result<ScatterBaker::Sums> ScatterBaker::sumStack(const ScatterPasses::Settings& settings,
                                                  const BakeVertices& vertices,
                                                  std::span<const PointShape> shapes,
                                                  const std::vector<float>& facets,
                                                  const BakeProgress& progress) const {
    Result<ScatterPasses> passes = passesFor(settings, facets);
    if (!passes) {
        return passes.status();
    }
    const MapStack& stack = settings.stack;
    const PointTarget target{{stack.mapSize.x, stack.mapSize.y * stack.count}, facets};
    Sums sums;
    sums.coverage = chartCoverage(gpu_.geometry, shapes, stack, target, coveragePlaces);
    sums.light.resize(settings.draws ? 0 : facets.size());
    std::optional<PointWeights> weights;
    if (!settings.draws) {
        weights.emplace(gpu_.geometry, gpu_.frame,
                        PointWeights::Settings{stack.mapSize, settings.density, settings.ground});
    }
    DirectionPlan plan;
    plan.last = options_.directions;
    plan.atOnce = directionsAtOnce;
    plan.pictureSize = settings.rasterSize;
    plan.sky = options_.sky;
    plan.seed = options_.seed;
    const auto add = [&](std::span<const LightView> views) {
        for (const LightView& view : views) {
            passes->drawSurface(vertices, view);
            if (settings.draws) {
                passes->scatter(view);
            } else {
                PictureAdder(shapes, *weights, stack, target)
                    .add(passes->readSurface(), view, sums.light);
            }
        }
    };
    if (Status status = gpu_.addDirections(plan, progress, add); !status) {
        return status;
    }
    if (settings.draws) {
        const gl::StateGuard guard(*gpu_.gl);
        sums.light = passes->sums();
    }
    return sums;
}

BakedMap ScatterBaker::mapOf(const TexelRaster& raster, const TexelSums& own,
                             const MapOptions& options) const {
    BakedMap map = emptyMap(raster);
    const bool eroded = options_.seams == SeamFix::Erosion;
    const double norm = cosineNorm(options_.sky, options_.directions);
    for (std::size_t i = 0; i < raster.size(); ++i) {
        if (raster.kind(i) == TexelKind::Empty || (eroded && raster.kind(i) != TexelKind::Inside)) {
            continue;
        }
        const glm::vec2& b = raster.barycentric(i);
        const std::optional<SurfacePoint> point =
            gpu_.geometry.point(raster.triangle(i), double{b.x}, double{b.y});
        if (point) {
            setTexel(map, i, eroded ? own.light[i] : lightPerCoverage(own, i), norm, point->normal);
        }
    }
    if (eroded) {
        erode(map);
    }
    if (options_.normalisation == Normalisation::Brightest) {
        const float most = *std::max_element(map.visibility.begin(), map.visibility.end());
        for (float& w : map.visibility) {
            w = w >= 0.0F && most > 0.0F ? w / most : w;
        }
    }
    std::transform(map.visibility.begin(), map.visibility.end(), map.visibility.begin(),
                   [](float w) { return std::min(w, 1.0F); });
    for (std::size_t i = 0; i < options.wanted.size(); ++i) {
        map.visibility[i] = options.wanted[i] != 0 ? map.visibility[i] : -1.0F;
    }
    finish(map, options);
    return map;
}

Result<std::vector<BakedMap>> ScatterBaker::bakeMaps(const MapOptions& options,
                                                     const BakeProgress& progress) try {
    if (Status status = check(options); !status) {
        return status;
    }
    const int count = gpu_.geometry.scene().mapCount();
    const int atOnce = gpu_.gl->capabilities.maxTextureSize / options.height;
    if (atOnce < 1 || options.width > gpu_.gl->capabilities.maxTextureSize) {
        return Status(StatusCode::MissingCapability,
                      "this context has textures of up to " +
                          std::to_string(gpu_.gl->capabilities.maxTextureSize) + " texels a side");
    }
    std::vector<TexelRaster> rasters;
    bool covered = false;
    for (int number = 0; number < count; ++number) {
        rasters.emplace_back(gpu_.geometry.scene(), number, options.width, options.height);
        covered = covered || rasters.back().coveredTexels() > 0;
    }
    if (!covered) {
        return noTexels();
    }
    ScatterPasses::Settings settings;
    settings.rasterSize = rasterSize({options.width, options.height});
    settings.pointSize = options_.pointSize;
    settings.density = options_.stretchCorrection ? 0.0F : density(rasters);
    settings.ground = gpu_.ground();
    settings.draws = drawsPoints(options_.sum, gpu_.gl->capabilities.software);
    const Facets facets(gpu_.geometry.scene());
    const std::vector<PointShape> shapes =
        pointShapes(gpu_.geometry, gpu_.frame, facets,
                    {{options.width, options.height},
                     ScatterPasses::pictureSide / float(settings.rasterSize),
                     options_.pointSize});
    const Result<BakeVertices> vertices = gpu_.upload(options.width, options.height, &facets);
    if (!vertices) {
        return vertices.status();
    }
    std::vector<BakedMap> maps;
    for (int first = 0; first < count; first += atOnce) {
        settings.stack = {{options.width, options.height}, first, std::min(atOnce, count - first)};
        const auto share = [&](double fraction) {
            return !progress || progress((first + fraction * settings.stack.count) / count);
        };
        std::vector<float> owners;
        for (int i = 0; i < settings.stack.count; ++i) {
            const std::vector<float> more = facets.ofTexels(
                gpu_.geometry.scene(), rasters[static_cast<std::size_t>(first + i)]);
            owners.insert(owners.end(), more.begin(), more.end());
        }
        const Result<Sums> sums = sumStack(settings, *vertices, shapes, owners, share);
        if (!sums) {
            return sums.status();
        }
        for (int i = 0; i < settings.stack.count; ++i) {
            const TexelRaster& raster = rasters[static_cast<std::size_t>(first + i)];
            const std::size_t start = static_cast<std::size_t>(i) * raster.size();
            maps.push_back(
                mapOf(raster,
                      {settings.stack.mapSize, std::span(sums->light).subspan(start, raster.size()),
                       std::span(sums->coverage).subspan(start, raster.size()),
                       std::span(owners).subspan(start, raster.size())},
                      options));
        }
    }
    if (progress) {
        progress(1.0);
    }
    return maps;
} catch (const std::bad_alloc&) {
    return noMemoryForMaps(options);
}

Result<std::unique_ptr<AbstractBaker>> createScatterBaker(const ProcAddressLoader& loader,
                                                          BakeScene scene,
                                                          const ScatterOptions& options) {
    return createGpuBaker<ScatterBaker>(loader, std::move(scene), options);
}

} // namespace aolib::bake
