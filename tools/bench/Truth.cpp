#include "bench/Truth.h"

#include <sstream>
#include <utility>

#include "bench/TruthCache.h"

namespace aolib::bench {

namespace {

/// Named in the key: raise it when the way of tracing changes.
constexpr int kTracingVersion = 1;

Result<VisibilityList, LoadError> trace(const OpenedScene& scene, const BenchCase& which,
                                        const TruthSettings& settings,
                                        const std::vector<Receiver>& points,
                                        const LoopProgress& progress) {
    TraceSettings tracing;
    tracing.rays = settings.rays;
    tracing.radius = which.radiusShare * scene.diagonal;
    tracing.seed = settings.seed;
    const Result<VisibilityTracer> tracer = VisibilityTracer::create(scene.rays, tracing);
    if (!tracer) {
        return LoadError{scene.entry.name + ": " + tracer.status().message()};
    }
    Result<VisibilityList> traced = tracer->trace(points, progress);
    if (!traced) {
        return LoadError{scene.entry.name + ": " + traced.status().message()};
    }
    if (!traced->complete) {
        return LoadError{scene.entry.name + ": tracing was cancelled"};
    }
    return std::move(*traced);
}

void write(std::ostream& text, const glm::vec3& v) {
    text << v.x << ' ' << v.y << ' ' << v.z << '\n';
}

} // namespace

std::string truthKey(const OpenedScene& scene, const BenchCase& which,
                     const TruthSettings& settings) {
    const NamedCamera& camera = scene.cameras[which.camera];
    std::ostringstream text;
    text << std::hexfloat << "truth " << kTracingVersion << "\ntriangles " << scene.fingerprint
         << "\ndiagonal " << scene.diagonal << "\nradius " << which.radiusShare
         << "\nfalloff step, geometric normals\n";
    write(text, camera.eye);
    write(text, camera.target);
    write(text, camera.up);
    text << camera.fovyDeg << ' ' << camera.near << ' ' << camera.far << "\nsize "
         << settings.size.width << " x " << settings.size.height << " stride " << settings.stride
         << "\nrays " << settings.rays << " seed " << settings.seed << '\n';
    return text.str();
}

Result<Truth, LoadError> traceTruth(const OpenedScene& scene, const BenchCase& which,
                                    const TruthSettings& settings,
                                    const std::filesystem::path& cache,
                                    const LoopProgress& progress) {
    Truth truth;
    truth.receivers = findReceivers(scene.rays, scene.cameras[which.camera], settings.size,
                                    latticePixels(settings.size, settings.stride, settings.seed));
    const std::size_t count = truth.receivers.points.size();
    const TruthCache store(cache);
    const std::string key = truthKey(scene, which, settings);
    if (auto kept = store.read(key, count)) {
        truth.visibility = std::move(kept->visibility);
        truth.standardError = std::move(kept->standardError);
        truth.noise = noiseOf(truth.standardError);
        truth.fromCache = true;
        return truth;
    }
    Result<VisibilityList, LoadError> traced =
        trace(scene, which, settings, truth.receivers.points, progress);
    if (!traced) {
        return LoadError{traced.error().sentence};
    }
    truth.visibility = std::move(traced->visibility);
    truth.standardError = std::move(traced->standardError);
    truth.noise = traced->noise;
    if (const std::string reason = store.write(key, truth.visibility, truth.standardError);
        !reason.empty()) {
        return LoadError{reason};
    }
    return truth;
}

Result<std::size_t, LoadError> followPicture(const OpenedScene& scene, const BenchCase& which,
                                             const TruthSettings& settings,
                                             std::vector<float> depths, Truth& truth) {
    truth.drawn = std::move(depths);
    const std::vector<std::size_t> moved = followPicture(
        scene.rays, scene.cameras[which.camera], settings.size, truth.drawn, truth.receivers);
    std::vector<Receiver> points;
    for (const std::size_t i : moved) {
        points.push_back(truth.receivers.points[i]);
    }
    const Result<VisibilityList, LoadError> traced = trace(scene, which, settings, points, {});
    if (!traced) {
        return LoadError{traced.error().sentence};
    }
    for (std::size_t i = 0; i < moved.size(); ++i) {
        truth.visibility[moved[i]] = traced->visibility[i];
        truth.standardError[moved[i]] = traced->standardError[i];
    }
    truth.noise = noiseOf(truth.standardError);
    return moved.size();
}

} // namespace aolib::bench
