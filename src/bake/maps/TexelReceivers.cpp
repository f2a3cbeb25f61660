#include "bake/maps/TexelReceivers.h"

#include <algorithm>

#include "raytracing/SobolSequence.h"

namespace aolib::bake {

SampleRange sampleRange(int count, int place, int places) {
    const auto start = [&](int number) {
        return static_cast<int>(std::int64_t{count} * number / places);
    };
    return {start(place), start(place + 1)};
}

TexelReceivers::TexelReceivers(const BakeGeometry& geometry, const Facets& facets, int map,
                               const MapOptions& options)
    : geometry_(&geometry), facets_(&facets), map_(map), most_(options.texelSamples),
      wanted_(&options.wanted), centres_(geometry.scene(), map, options.width, options.height),
      triangle_(centres_.size()), barycentric_(centres_.size()) {
    moveTo(0, 1);
}

int TexelReceivers::placesFor(int samples, int least) const {
    return std::clamp(samples / least, 1, most_);
}

void TexelReceivers::moveTo(int place, int places) {
    if (place == 0) {
        take(centres_, false);
    }
    if (places > 1) {
        const auto index = static_cast<std::uint32_t>(place);
        // Sobol's points lie at the lower left of their cells.
        const glm::dvec2 corner =
            glm::dvec2(bitReversed(index), bitReversed(sobolSecond(index))) * 0x1p-32;
        take(TexelRaster(geometry_->scene(), map_, centres_.width(), centres_.height(),
                         corner + 0.5 / double(places)),
             true);
    }
}

/// @param inFacet  only of texels that show a triangle of the same facet as at their centre.
void TexelReceivers::take(const TexelRaster& raster, bool inFacet) {
    const BakeScene& scene = geometry_->scene();
    for (std::size_t i = 0; i < raster.size(); ++i) {
        const bool fits = !inFacet || (raster.kind(i) == TexelKind::Inside &&
                                       centres_.kind(i) != TexelKind::Empty &&
                                       facets_->ofTriangle(scene, raster.triangle(i)) ==
                                           facets_->ofTriangle(scene, centres_.triangle(i)));
        if (fits) {
            triangle_[i] = raster.triangle(i);
            barycentric_[i] = raster.barycentric(i);
        }
    }
}

bool TexelReceivers::has(std::size_t texel) const {
    return centres_.kind(texel) != TexelKind::Empty && (wanted_->empty() || (*wanted_)[texel] != 0);
}

std::optional<SurfacePoint> TexelReceivers::at(std::size_t texel) const {
    if (!has(texel)) {
        return std::nullopt;
    }
    const glm::vec2& b = barycentric_[texel];
    return geometry_->point(triangle_[texel], double{b.x}, double{b.y});
}

std::optional<SurfacePoint> TexelReceivers::centre(std::size_t texel) const {
    if (!has(texel)) {
        return std::nullopt;
    }
    const glm::vec2& b = centres_.barycentric(texel);
    return geometry_->point(centres_.triangle(texel), double{b.x}, double{b.y});
}

} // namespace aolib::bake
