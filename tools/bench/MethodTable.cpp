#include "bench/MethodTable.h"

#include <algorithm>
#include <utility>

namespace aolib::bench {

namespace {

constexpr bool kOnRequest = false;

std::string across(int slices, int steps) {
    return std::to_string(slices) + "x" + std::to_string(steps);
}

Options atOnce() {
    Options options;
    options.frameBudget = 0.0F;
    options.cubeMaps.place = false;
    return options;
}

Method horizonCube(int directions, int steps, int faceSize) {
    Options options = atOnce();
    options.estimator = Estimator::HorizonSplit;
    options.horizonSplit = {.directions = directions, .steps = steps};
    options.cubeMaps.faceSize = faceSize;
    const std::string size = std::to_string(faceSize);
    return {"horizon-" + across(directions, steps) + "-" + size,
            across(directions, steps) + " " + size, Family::HorizonCube, FacadeMethod{options, 1}};
}

Method layeredCube(int slices, int steps, int faceSize, int cubeMaps, bool standard = true) {
    Options options = atOnce();
    options.estimator = Estimator::LayeredIntervals;
    options.layeredIntervals.slices = slices;
    options.layeredIntervals.steps = steps;
    options.cubeMaps.faceSize = faceSize;
    options.cubeMaps.nearest = std::max(cubeMaps, 1);
    const std::string size = std::to_string(faceSize);
    const bool many = cubeMaps > 1;
    return {"layered-" + across(slices, steps) + "-" + size +
                (many ? "-" + std::to_string(cubeMaps) + "maps" : ""),
            across(slices, steps) + " " + size, many ? Family::LayeredCubeTen : Family::LayeredCube,
            FacadeMethod{options, cubeMaps, /*tracer=*/false}, standard};
}

Method rayTracedCube(int rays, int faceSize, int cubeMaps = 1) {
    Options options = atOnce();
    options.estimator = Estimator::RayTraced;
    options.rayTraced.rays = rays;
    options.frameBudget = 5.0F;
    options.cubeMaps.faceSize = faceSize;
    options.cubeMaps.nearest = cubeMaps;
    const std::string size = std::to_string(faceSize);
    return {"traced-" + std::to_string(rays) + "-" + size +
                (cubeMaps > 1 ? "-" + std::to_string(cubeMaps) + "maps" : ""),
            std::to_string(rays) + " " + size, Family::RayTracedCube,
            FacadeMethod{options, cubeMaps}};
}

/// A variant of a method, run on request; the caller changes what it measures.
FacadeMethod& named(Method& method, const std::string& suffix, const std::string& label) {
    method.name += suffix;
    method.label += label;
    method.standard = kOnRequest;
    return std::get<FacadeMethod>(method.how);
}

/// The same as a moving camera sees it: pixels are not computed themselves, and no frame has the
/// view of the one before.
Method moving(Method method) {
    FacadeMethod& facade = named(method, "-moving", " moving");
    facade.options.cubeMaps.refineStaticViews = false;
    facade.moving = true;
    return method;
}

/// The same projected at half the resolution.
Method halved(Method method) {
    named(method, "-half", " half").options.cubeMaps.halfResolution = true;
    return method;
}

/// The same a little in every frame: what the first frame shows is no more than begun.
Method paced(Method method) {
    named(method, "-paced", " paced").options.frameBudget = 5.0F;
    return method;
}

/// The same where pixels of the view at rest can be traced.
Method tracedAtRest(Method method) {
    named(method, "-traced", " traced pixels").tracer = true;
    return method;
}

Method horizonScreen(int directions, int steps) {
    Options options;
    options.backbone = Backbone::ScreenSpace;
    options.estimator = Estimator::HorizonSplit;
    options.horizonSplit = {.directions = directions, .steps = steps};
    return {"screen-horizon-" + across(directions, steps), across(directions, steps),
            Family::HorizonScreen, FacadeMethod{options, 0}};
}

Method layeredScreen(int slices, int steps, bool blur) {
    Options options;
    options.backbone = Backbone::ScreenSpace;
    options.estimator = Estimator::LayeredIntervals;
    options.layeredIntervals.slices = slices;
    options.layeredIntervals.steps = steps;
    options.blur.enabled = blur;
    return {"screen-layered-" + across(slices, steps) + (blur ? "" : "-noblur"),
            across(slices, steps), blur ? Family::LayeredScreen : Family::LayeredScreenRaw,
            FacadeMethod{options, 0}};
}

Method surfaceElements(int elements, bool standard = true) {
    const std::string count = std::to_string(elements / 1000) + "k";
    return {"surfels-" + count, count, Family::SurfaceElements, SurfaceElementsMethod{elements},
            standard};
}

Method fewRays(int rays) {
    return {"rays-" + std::to_string(rays), std::to_string(rays), Family::FewRays,
            FewRaysMethod{rays}};
}

} // namespace

const std::vector<Family>& families() {
    static const std::vector<Family> all{
        Family::LayeredCube,      Family::LayeredCubeTen,  Family::RayTracedCube,
        Family::HorizonCube,      Family::HorizonScreen,   Family::LayeredScreen,
        Family::LayeredScreenRaw, Family::SurfaceElements, Family::FewRays};
    return all;
}

std::string_view familyName(Family family) {
    switch (family) {
    case Family::HorizonCube:
        return "aolib: horizon split (thesis), one cube map";
    case Family::RayTracedCube:
        return "aolib: ray-traced texels";
    case Family::LayeredCube:
        return "aolib: layered intervals, one cube map";
    case Family::LayeredCubeTen:
        return "aolib: layered intervals, ten cube maps";
    case Family::HorizonScreen:
        return "screen space: horizon split";
    case Family::LayeredScreen:
        return "screen space: cosine-exact slices, blur";
    case Family::LayeredScreenRaw:
        return "screen space: cosine-exact slices, no blur";
    case Family::SurfaceElements:
        return "surface elements (discs per vertex)";
    case Family::FewRays:
        return "ray tracing, every pixel every frame";
    }
    return "";
}

const std::vector<Method>& benchMethods() {
    static const std::vector<Method> methods{
        layeredCube(4, 8, 256, 1),
        layeredCube(8, 16, 256, 1),
        layeredCube(4, 8, 512, 1),
        layeredCube(8, 16, 512, 1),
        layeredCube(16, 32, 256, 1, kOnRequest),
        layeredCube(16, 32, 512, 1),
        tracedAtRest(layeredCube(8, 16, 512, 1)),
        tracedAtRest(layeredCube(16, 32, 512, 1)),
        moving(layeredCube(8, 16, 256, 1)),
        moving(layeredCube(8, 16, 512, 1)),
        paced(moving(layeredCube(8, 16, 512, 1))),
        moving(layeredCube(16, 32, 512, 1)),
        layeredCube(4, 8, 1024, 1, kOnRequest),
        layeredCube(8, 16, 1024, 1),
        layeredCube(16, 32, 1024, 1, kOnRequest),
        layeredCube(4, 8, 256, 10),
        layeredCube(8, 16, 256, 10, kOnRequest),
        layeredCube(8, 16, 512, 10, kOnRequest),
        rayTracedCube(64, 512),
        rayTracedCube(256, 512),
        rayTracedCube(1024, 512),
        rayTracedCube(256, 1024),
        rayTracedCube(256, 512, 10),
        moving(rayTracedCube(256, 512)),
        moving(rayTracedCube(256, 512, 10)),
        halved(moving(rayTracedCube(256, 512))),
        halved(moving(rayTracedCube(256, 512, 10))),
        horizonCube(16, 16, 256),
        horizonCube(16, 16, 512),
        horizonScreen(8, 8),
        horizonScreen(16, 16),
        layeredScreen(2, 8, true),
        layeredScreen(4, 8, true),
        layeredScreen(8, 16, true),
        layeredScreen(2, 8, false),
        layeredScreen(4, 8, false),
        layeredScreen(8, 16, false),
        surfaceElements(20000),
        surfaceElements(80000),
        surfaceElements(320000, kOnRequest),
        fewRays(1),
        fewRays(4),
        fewRays(16),
        fewRays(64),
    };
    return methods;
}

bool matches(std::string_view pattern, std::string_view name) {
    if (pattern.empty()) {
        return name.empty();
    }
    if (pattern.front() == '*') {
        return matches(pattern.substr(1), name) ||
               (!name.empty() && matches(pattern, name.substr(1)));
    }
    return !name.empty() && (pattern.front() == '?' || pattern.front() == name.front()) &&
           matches(pattern.substr(1), name.substr(1));
}

std::vector<Method> chooseMethods(const std::vector<std::string>& patterns) {
    std::vector<Method> chosen;
    for (const Method& method : benchMethods()) {
        const bool named = std::any_of(patterns.begin(), patterns.end(), [&](const std::string& p) {
            return matches(p, method.name);
        });
        if (named || (patterns.empty() && method.standard)) {
            chosen.push_back(method);
        }
    }
    return chosen;
}

} // namespace aolib::bench
