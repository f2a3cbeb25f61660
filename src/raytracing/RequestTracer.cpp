#include "raytracing/RequestTracer.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "raytracing/CosineSampling.h"
#include "raytracing/GroupTracer.h"
#include "raytracing/RayChunk.h"
#include "raytracing/SurfaceFinder.h"
#include "raytracing/SurfaceGroup.h"
#include "shared/folded_place.h"

namespace aolib {

namespace {

constexpr int largestFace = 65536;
constexpr int longestSequence = 1 << 30;
constexpr int mostTexels = 1 << 24;
/// Normals with at least this cosine are one: they differ by a microradian, as rounded to float.
constexpr double sameCosine = 1.0 - 1e-12;
/// Texels are visited in blocks of this edge, a packet's worth: what they see is close together.
constexpr int blockEdge = 4;
static_assert(std::size_t{blockEdge * blockEdge} == SurfaceFinder::packet);

bool within(int begin, int count, int end) {
    return begin >= 0 && count >= 1 && begin < end && count <= end - begin;
}

AoStatus invalid(const std::string& what) {
    return {StatusCode::InvalidOption, "a request for texels: " + what};
}

AoStatus checkPlaces(const TexelRequest& request) {
    if (request.faceSize < 1 || request.faceSize > largestFace) {
        return invalid("face size is " + std::to_string(request.faceSize) + ", must be 1 to 65536");
    }
    if (!within(request.x, request.width, request.faceSize) ||
        !within(request.y, request.height, request.faceSize)) {
        return invalid(std::to_string(request.width) + " x " + std::to_string(request.height) +
                       " texels at (" + std::to_string(request.x) + ", " +
                       std::to_string(request.y) + ") of a face of " +
                       std::to_string(request.faceSize));
    }
    return {};
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

AoStatus checkSights(const TexelRequest& request) {
    const auto texels = static_cast<std::size_t>(std::max(request.width, 0)) *
                        static_cast<std::size_t>(std::max(request.height, 0));
    if (request.primaryRays.size() != texels) {
        return invalid(std::to_string(request.width) + " x " + std::to_string(request.height) +
                       " of them with " + std::to_string(request.primaryRays.size()) +
                       " lines of sight");
    }
    for (const LineOfSight& line : request.primaryRays) {
        if (!isFinite(line.from) || !isFinite(line.to) || line.from == line.to) {
            return {StatusCode::InvalidPosition,
                    "a request for texels: a line of sight that is not finite or has no length"};
        }
    }
    return {};
}

/// One request on its way.
class RequestTracer {
public:
    RequestTracer(const RayScene& scene, const TexelRequest& request, const KeepGoing& keepGoing);

    bool traceAll();
    TracedTexels&& result() { return std::move(result_); }

private:
    struct RayPattern {
        glm::dmat3 basis;
        SequenceSeed seed;
    };

    bool traceBlock(int column, int row);
    RayPattern rayPattern(const SurfaceFinder::Texel& texel, const glm::dvec3& normal) const;
    bool traceGroup();

    const RayScene& scene_;
    const KeepGoing& keepGoing_;
    SurfaceFinder finder_;
    GroupTracer tracer_;
    SurfaceGroup group_;
    TracedTexels result_;
};

RequestTracer::RequestTracer(const RayScene& scene, const TexelRequest& request,
                             const KeepGoing& keepGoing)
    : scene_(scene), keepGoing_(keepGoing), finder_(scene, request),
      tracer_(scene, request.falloff, request.radius) {
    const std::size_t texels =
        static_cast<std::size_t>(request.width) * static_cast<std::size_t>(request.height);
    result_.request = request;
    result_.visibility.assign(texels, 1.0F);
    result_.distance.assign(texels, -1.0F);
    result_.normal.assign(texels, glm::vec3(0.0F));
}

bool RequestTracer::traceAll() {
    const TexelRequest& request = result_.request;
    for (int row = 0; row < request.height; row += blockEdge) {
        for (int column = 0; column < request.width; column += blockEdge) {
            if (!traceBlock(column, row)) {
                return false;
            }
        }
    }
    return group_.count == 0 || traceGroup();
}

/// Finds what a block's texels see, and traces whenever a group is full.
/// @param column, row  of the request's own texels.
bool RequestTracer::traceBlock(int column, int row) {
    const TexelRequest& request = result_.request;
    std::array<SurfaceFinder::Texel, SurfaceFinder::packet> texels;
    std::array<std::size_t, SurfaceFinder::packet> places{};
    std::size_t count = 0;
    for (int y = row; y < std::min(row + blockEdge, request.height); ++y) {
        for (int x = column; x < std::min(column + blockEdge, request.width); ++x) {
            texels[count] = {x, y};
            places[count++] = static_cast<std::size_t>(y) * std::size_t(request.width) +
                              static_cast<std::size_t>(x);
        }
    }
    const SurfaceFinder::SeenList seen = finder_.find({texels.data(), count});
    for (std::size_t i = 0; i < count; ++i) {
        if (!seen[i]) {
            continue;
        }
        result_.distance[places[i]] = static_cast<float>(seen[i]->hit.distance);
        result_.normal[places[i]] = glm::vec3(seen[i]->normal);
        // Off its own surface, and off any other that it touches: what sees it is before both.
        const glm::dvec3& position = seen[i]->hit.position;
        const double touch = scene_.resolution(position, glm::dvec3(1.0));
        const glm::dvec3 lifted =
            position + seen[i]->hit.clearance * seen[i]->normal - touch * seen[i]->direction;
        const RayPattern pattern = rayPattern(texels[i], seen[i]->shading);
        const bool same = glm::dot(seen[i]->shading, seen[i]->normal) >= sameCosine;
        group_.add({glm::vec3(scene_.toFrame(lifted)), glm::mat3(pattern.basis),
                    same ? glm::vec3(0.0F) : glm::vec3(seen[i]->normal), pattern.seed, places[i]});
        if (group_.full() && !traceGroup()) {
            return false;
        }
    }
    return keepGoing_();
}

/// How a texel's rays are spread about its normal: by where it lies on its face, so that the
/// pattern turns with the cube. Lines of sight have no face; their places alone count.
RequestTracer::RayPattern RequestTracer::rayPattern(const SurfaceFinder::Texel& texel,
                                                    const glm::dvec3& normal) const {
    const TexelRequest& request = result_.request;
    const glm::ivec2 at(request.x + texel.x, request.y + texel.y);
    if (!request.primaryRays.empty()) {
        return {basisAbout(normal), sequenceSeed(request.face, at.x, at.y)};
    }
    const shared::FoldedPlace place = shared::foldedPlace(at, request.faceSize);
    const auto axisAfter = [&](int quarters) {
        return glm::dvec3(shared::turnedRight(request.face, (place.quarters + quarters) & 3));
    };
    const bool sideways = std::abs(glm::dot(axisAfter(0), normal)) > 0.9;
    const glm::dvec3 axis = axisAfter(sideways ? 1 : 0);
    const glm::dvec3 right = glm::normalize(axis - glm::dot(axis, normal) * normal);
    return {{right, glm::cross(normal, right), normal}, sequenceSeed(0, place.at.x, place.at.y)};
}

/// Traces the group's rays, in chunks that are as long as they can be.
bool RequestTracer::traceGroup() {
    const TexelRequest& request = result_.request;
    const int end = request.firstRay + request.rays;
    std::array<double, SurfaceGroup::capacity> sums{};
    for (int start = request.firstRay; start < end;) {
        const int count = static_cast<int>(
            RayChunk::longest(static_cast<std::uint32_t>(start), static_cast<std::uint32_t>(end)));
        GroupTracer::Sums chunk{};
        tracer_.trace(group_, static_cast<std::uint32_t>(start), count, chunk);
        std::transform(sums.begin(), sums.end(), chunk.begin(), sums.begin(),
                       [](double sum, float more) { return sum + double{more}; });
        start += count;
        if (!keepGoing_()) {
            return false;
        }
    }
    for (std::size_t i = 0; i < group_.count; ++i) {
        result_.visibility[group_.surfaces[i].texel] =
            static_cast<float>(1.0 - sums[i] / double(request.rays));
    }
    group_.clear();
    return true;
}

} // namespace

AoStatus checkRequest(const TexelRequest& request) {
    if (!isFinite(request.centre)) {
        return {StatusCode::InvalidPosition,
                "a request for texels: the centre of the cube map is not finite"};
    }
    if (request.face < 0 || request.face > 5) {
        return invalid("face is " + std::to_string(request.face) + ", must be 0 to 5");
    }
    const AoStatus places =
        request.primaryRays.empty() ? checkPlaces(request) : checkSights(request);
    if (!places) {
        return places;
    }
    if (request.height > mostTexels / request.width) {
        return invalid(std::to_string(request.width) + " x " + std::to_string(request.height) +
                       " of them are more than 2^24");
    }
    if (!within(request.firstRay, request.rays, longestSequence)) {
        return invalid(std::to_string(request.rays) + " rays from " +
                       std::to_string(request.firstRay) + " on, must be 1 or more within 2^30");
    }
    const bool reaches = std::isfinite(request.radius) && request.radius > 0.0F;
    if (request.falloff != Falloff::Off && !reaches) {
        return invalid("radius is " + std::to_string(request.radius) + ", must be above 0");
    }
    return {};
}

std::optional<TracedTexels> traceRequest(const RayScene& scene, const TexelRequest& request,
                                         const KeepGoing& keepGoing) {
    RequestTracer tracer(scene, request, keepGoing);
    if (!tracer.traceAll()) {
        return std::nullopt;
    }
    return tracer.result();
}

} // namespace aolib
