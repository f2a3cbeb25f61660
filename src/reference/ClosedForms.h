#pragma once

#include <algorithm>
#include <cmath>

namespace aolib {

/// Occlusion `1 - W` known exactly: what tracer and estimators are checked against. All lengths in
/// one unit; distances along normals are positive.

/// A point on a floor, its normal straight up, beside an endless wall; no falloff.
/// The wall covers the elevations below `atan(height / distance)` on one side.
/// @param distance  to the wall, above 0.
inline double wallOcclusion(double height, double distance) {
    return 0.5 * (1.0 - distance / std::hypot(distance, height));
}

/// A disc straight above the point, facing it; no falloff. Its form factor.
/// @param height  of the disc above the point, above 0.
inline double discOcclusion(double discRadius, double height) {
    const double r2 = discRadius * discRadius;
    return r2 / (r2 + height * height);
}

/// The same disc under `Falloff::Step`: only its part within `radius` of the point counts, again a
/// disc, with the radius `sqrt(radius^2 - height^2)`.
inline double discOcclusionStep(double discRadius, double height, double radius) {
    if (radius <= height) {
        return 0.0;
    }
    const double within = std::sqrt(radius * radius - height * height);
    return discOcclusion(std::min(discRadius, within), height);
}

/// Any closed room without falloff.
inline double closedRoomOcclusion() {
    return 1.0;
}

/// A plane with nothing above it.
inline double lonePlaneOcclusion() {
    return 0.0;
}

/// A point on the inside of a sphere under `Falloff::Step`. A chord at the angle theta to the
/// normal is `2 R cos(theta)` long, so only directions with `cos(theta) < radius / 2R` are blocked.
inline double insideSphereOcclusionStep(double sphereRadius, double radius) {
    const double cosine = std::min(1.0, radius / (2.0 * sphereRadius));
    return cosine * cosine;
}

/// A point on the inside of a sphere under `Falloff::Exp`: the integral of
/// `2 mu e^(-a mu)` over mu = cos(theta) from 0 to 1 with `a = 2R / radius`.
inline double insideSphereOcclusionExp(double sphereRadius, double radius) {
    const double a = 2.0 * sphereRadius / radius;
    return 2.0 * (1.0 - (1.0 + a) * std::exp(-a)) / (a * a);
}

} // namespace aolib
