#pragma once

#include <cstdint>
#include <vector>

#include <aolib/bake/BakeScene.h>

#include "bake/geometry/BakeGeometry.h"
#include "bake/maps/TexelRaster.h"

namespace aolib::bake {

/// The parts of charts within which a texel may take what falls beside it: triangles that hang
/// together in the map, without a crease. A crease parts vertices whose normals are more than 45
/// degrees apart; vertices that triangles share never are.
class Facets {
public:
    explicit Facets(const BakeScene& scene);

    /// Numbers from 1, whole and exact as floats.
    float ofVertex(std::size_t surface, std::size_t vertex) const {
        return number_[surface][vertex];
    }
    float ofTriangle(const BakeScene& scene, const TriangleName& name) const {
        const auto& indices = scene.surfaces[name.surface].indices;
        return ofVertex(name.surface, indices[std::size_t{name.triangle} * 3]);
    }
    /// Per texel the facet that it shows, 0 where it is empty.
    std::vector<float> ofTexels(const BakeScene& scene, const TexelRaster& raster) const;

private:
    std::vector<std::vector<float>> number_;
};

} // namespace aolib::bake
