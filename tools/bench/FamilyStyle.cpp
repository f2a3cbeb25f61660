#include "bench/FamilyStyle.h"

namespace aolib::bench {

FamilyStyle styleOf(Family family) {
    constexpr double ours = 2.8;
    constexpr double others = 1.6;
    constexpr double dashes = 6.0;
    switch (family) {
    case Family::LayeredCube:
        return {{0, 90, 181}, Marker::Disc, ours, 0.0};
    case Family::LayeredCubeTen:
        return {{38, 160, 218}, Marker::Ring, ours, 0.0};
    case Family::RayTracedCube:
        return {{200, 30, 90}, Marker::Disc, ours, 0.0};
    case Family::HorizonCube:
        return {{128, 70, 160}, Marker::Square, others, 0.0};
    case Family::HorizonScreen:
        return {{190, 120, 200}, Marker::Square, others, dashes};
    case Family::LayeredScreen:
        return {{0, 135, 90}, Marker::TriangleUp, others, 0.0};
    case Family::LayeredScreenRaw:
        return {{110, 180, 60}, Marker::TriangleDown, others, dashes};
    case Family::SurfaceElements:
        return {{150, 95, 45}, Marker::Diamond, others, 0.0};
    case Family::FewRays:
        return {{213, 70, 40}, Marker::Disc, others, 0.0};
    }
    return {};
}

} // namespace aolib::bench
