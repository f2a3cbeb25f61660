#include "bake/scatter/ScatterMaps.h"

#include <algorithm>
#include <new>
#include <span>
#include <string>
#include <utility>

#include "bake/geometry/SurfaceSamples.h"
#include "bake/maps/MapFill.h"
#include "bake/maps/ProgressiveBake.h"
#include "bake/scatter/ChartCoverage.h"
#include "bake/scatter/CpuSplatter.h"
#include "bake/scatter/TexelDensity.h"
#include "bake/scatter/ThinTexels.h"
#include "gl/StateGuard.h"

namespace aolib::bake {

namespace {

/// Directions between two calls of the callbacks.
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

/// W of the brightest texel becomes 1.
void takeBrightestForOpen(BakedMap& map) {
    const float most = *std::max_element(map.visibility.begin(), map.visibility.end());
    for (float& w : map.visibility) {
        w = w >= 0.0F && most > 0.0F ? w / most : w;
    }
}

} // namespace

ScatterMaps::ScatterMaps(const GpuBake& gpu, const ScatterOptions& scatter,
                         const MapOptions& options)
    : gpu_(gpu), scatter_(scatter), options_(options), facets_(gpu.geometry.scene()) {}

std::size_t ScatterMaps::stackStart() const {
    return static_cast<std::size_t>(settings_.stack.first) * rasters_.front().size();
}

std::size_t ScatterMaps::stackSize() const {
    return static_cast<std::size_t>(settings_.stack.count) * rasters_.front().size();
}

/// Finds out what the texels of all maps show.
void ScatterMaps::rasterise() {
    for (int number = 0; number < gpu_.geometry.scene().mapCount(); ++number) {
        rasters_.emplace_back(gpu_.geometry.scene(), number, options_.width, options_.height);
        const std::vector<float> more = facets_.ofTexels(gpu_.geometry.scene(), rasters_.back());
        owners_.insert(owners_.end(), more.begin(), more.end());
    }
    coverage_.resize(owners_.size());
    light_.resize(owners_.size());
}

int ScatterMaps::rasterSize() const {
    const int mostTexels = gpu_.gl->capabilities.maxTextureSize;
    if (scatter_.rasterSize > 0) {
        return std::min(scatter_.rasterSize, mostTexels);
    }
    const double texels = texelsAlongUnit(
        gpu_.geometry, gpu_.frame, {double(options_.width), double(options_.height)}, finelyShown);
    const double size = pixelsAlongTexel * texels * double{ScatterPasses::pictureSide};
    return std::clamp((static_cast<int>(size) + 63) / 64 * 64, leastRaster,
                      std::min(largestRaster, mostTexels));
}

/// Square texels per square frame unit, if all charts were stretched alike.
float ScatterMaps::density() const {
    double texels = 0.0;
    for (const TexelRaster& raster : rasters_) {
        texels += static_cast<double>(raster.coveredTexels());
    }
    double area = 0.0;
    for (const SurfaceSample& sample : triangleCentres(gpu_.geometry)) {
        area += double{sample.area};
    }
    const double scale = gpu_.frame.scale();
    return static_cast<float>(texels / (area * scale * scale));
}

AoStatus ScatterMaps::run(const BakeProgress& progress, const SnapshotCallback& onSnapshot) {
    rasterise();
    if (std::none_of(rasters_.begin(), rasters_.end(),
                     [](const TexelRaster& raster) { return raster.coveredTexels() > 0; })) {
        return noTexels();
    }
    const glm::ivec2 mapSize(options_.width, options_.height);
    settings_.rasterSize = rasterSize();
    settings_.pointSize = scatter_.pointSize;
    settings_.density = scatter_.stretchCorrection ? 0.0F : density();
    settings_.ground = gpu_.ground();
    settings_.slabs = !gpu_.reach.endless();
    settings_.draws = drawsPoints(scatter_.sum, gpu_.gl->capabilities.software);
    shapes_ = pointShapes(
        gpu_.geometry, gpu_.frame, facets_,
        {mapSize, ScatterPasses::pictureSide / float(settings_.rasterSize), scatter_.pointSize});
    // All maps are summed at once, but where points are drawn and no texture is as large.
    const int mostTexels = gpu_.gl->capabilities.maxTextureSize;
    const int count = static_cast<int>(rasters_.size());
    const int atOnce = settings_.draws ? std::min(mostTexels / mapSize.y, count) : count;
    if (atOnce < 1 || (settings_.draws && mapSize.x > mostTexels)) {
        return {StatusCode::MissingCapability, "this context has textures of up to " +
                                                   std::to_string(mostTexels) + " texels a side"};
    }
    const Result<BakeVertices> vertices = gpu_.upload(mapSize.x, mapSize.y, &facets_);
    if (!vertices) {
        return vertices.status();
    }
    directions_ = scatter_.directions;
    for (int first = 0; first < count; first += atOnce) {
        settings_.stack = {mapSize, first, std::min(atOnce, count - first)};
        const auto share = [&](double fraction) {
            return !progress || progress((first + fraction * settings_.stack.count) / count);
        };
        // The first stack decides how many directions there are: the others get as many.
        if (AoStatus status =
                addStack(*vertices, share, first == 0 ? onSnapshot : SnapshotCallback());
            !status) {
            return status;
        }
    }
    return {};
}

/// Sums up the maps of a stack.
AoStatus ScatterMaps::addStack(const BakeVertices& vertices, const BakeProgress& progress,
                               const SnapshotCallback& onSnapshot) {
    const auto owners = std::span(owners_).subspan(stackStart(), stackSize());
    {
        const gl::StateGuard guard(*gpu_.gl);
        Result<ScatterPasses> passes = ScatterPasses::create(*gpu_.gl, settings_, vertices, owners);
        if (!passes) {
            return passes.status();
        }
        passes_ = std::move(*passes);
    }
    const MapStack& stack = settings_.stack;
    const PointTarget target{{stack.mapSize.x, stack.mapSize.y * stack.count}, owners};
    const std::vector<float> coverage =
        chartCoverage(gpu_.geometry, shapes_, stack, target, coveragePlaces);
    std::copy(coverage.begin(), coverage.end(),
              coverage_.begin() + static_cast<std::ptrdiff_t>(stackStart()));
    const Result<int> added = addDirections(target, progress, onSnapshot);
    if (!added) {
        return added.status();
    }
    directions_ = *added;
    fetch();
    passes_.reset();
    return {};
}

Result<int> ScatterMaps::addDirections(const PointTarget& target, const BakeProgress& progress,
                                       const SnapshotCallback& onSnapshot) {
    std::optional<CpuSplatter> splatter;
    if (!settings_.draws) {
        splatter.emplace(
            shapes_,
            PointWeights(gpu_.geometry, gpu_.frame,
                         {settings_.stack.mapSize, settings_.density, settings_.ground}),
            settings_.stack, target);
    }
    DirectionPlan plan;
    plan.last = directions_;
    plan.atOnce = directionsAtOnce;
    plan.pictureSize = settings_.rasterSize;
    plan.sky = scatter_.sky;
    plan.seed = scatter_.seed;
    const auto add = [&](std::span<const LightView> views) {
        AoStatus status;
        for (std::size_t i = 0; i < views.size() && status; ++i) {
            status = passes_->drawSurface(views[i], [&] {
                if (splatter) {
                    splatter->add(passes_->readSurface(), views[i],
                                  std::span(light_).subspan(stackStart(), stackSize()));
                } else {
                    passes_->scatter(views[i]);
                }
            });
        }
        return status;
    };
    const auto goOn = [&](int done) {
        directions_ = done;
        return !onSnapshot || onSnapshot(*this);
    };
    return gpu_.addDirections(plan, progress, add, goOn);
}

/// Reads what has been summed on the GPU.
void ScatterMaps::fetch() {
    if (settings_.draws && passes_) {
        const gl::StateGuard guard(*gpu_.gl);
        const std::vector<glm::vec4> sums = passes_->sums();
        std::copy(sums.begin(), sums.end(),
                  light_.begin() + static_cast<std::ptrdiff_t>(stackStart()));
    }
}

BakedMap ScatterMaps::makeMap(std::size_t number) const {
    const TexelRaster& raster = rasters_[number];
    const std::size_t start = number * raster.size();
    const TexelSums own{{options_.width, options_.height},
                        std::span(light_).subspan(start, raster.size()),
                        std::span(coverage_).subspan(start, raster.size()),
                        std::span(owners_).subspan(start, raster.size())};
    BakedMap map = emptyMap(raster);
    const bool eroded = scatter_.seams == SeamFix::Erosion;
    const double norm = cosineNorm(scatter_.sky, directions_);
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
    if (scatter_.normalisation == Normalisation::Brightest) {
        takeBrightestForOpen(map);
    }
    std::transform(map.visibility.begin(), map.visibility.end(), map.visibility.begin(),
                   [](float w) { return std::min(w, 1.0F); });
    for (std::size_t i = 0; i < options_.wanted.size(); ++i) {
        map.visibility[i] = options_.wanted[i] != 0 ? map.visibility[i] : -1.0F;
    }
    finish(map, options_);
    return map;
}

Result<std::vector<BakedMap>> ScatterMaps::maps() try {
    fetch();
    std::vector<BakedMap> maps;
    for (std::size_t number = 0; number < rasters_.size(); ++number) {
        maps.push_back(makeMap(number));
    }
    return maps;
} catch (const std::bad_alloc&) {
    return noMemoryForMaps(options_);
}

} // namespace aolib::bake
