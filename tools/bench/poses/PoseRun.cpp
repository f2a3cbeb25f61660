#include "bench/poses/PoseRun.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include <aolib/bake/AbstractBaker.h>
#include <aolib/bake/PoseBlend.h>

namespace aolib::bench {

namespace {

using Values = std::vector<float>;

/// What a bake gives.
struct Baked {
    Values visibility;
    std::vector<glm::vec3> bentNormal; ///< in the meshes' spaces at rest
};

Result<Baked> baked(const PosedModel& posed, int rays, std::uint32_t seed) {
    bake::BakeScene scene;
    for (const ModelMesh& mesh : posed.model.meshes) {
        Model alone;
        alone.meshes.push_back(mesh);
        TriangleMesh placed = alone.flattened();
        scene.surfaces.push_back({std::move(placed.positions),
                                  std::move(placed.normals),
                                  {},
                                  std::move(placed.indices),
                                  0});
    }
    bake::RayOptions options;
    options.rays = rays;
    options.seed = seed;
    const auto baker = bake::createRayBaker(std::move(scene), options);
    if (!baker) {
        return baker.status();
    }
    const auto vertices = (*baker)->bakeVertices({}, {});
    if (!vertices) {
        return vertices.status();
    }
    Baked all;
    for (std::size_t piece = 0; piece < vertices->size(); ++piece) {
        const bake::BakedVertices& values = (*vertices)[piece];
        all.visibility.insert(all.visibility.end(), values.visibility.begin(),
                              values.visibility.end());
        for (std::size_t i = 0; i < values.bentNormal.size(); ++i) {
            all.bentNormal.push_back(posed.atRest(piece, i, values.bentNormal[i]));
        }
    }
    return all;
}

/// Sums of squares that become an RMSE.
struct Error {
    double squares = 0.0;
    double count = 0.0;

    void add(const Values& values, const Values& truth) {
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const double error = double{values[i]} - double{truth[i]};
            squares += error * error;
        }
        count += static_cast<double>(truth.size());
    }
    double rmse() const { return count > 0.0 ? std::sqrt(squares / count) : 0.0; }
};

/// Angles whose mean is taken.
struct Angles {
    double sum = 0.0;
    double count = 0.0;

    void add(const std::vector<glm::vec3>& normals, const Baked& truth) {
        for (std::size_t i = 0; i < normals.size(); ++i) {
            if (truth.visibility[i] > 0.1F && truth.visibility[i] < 0.9F) {
                const double cosine{glm::dot(normals[i], truth.bentNormal[i])};
                sum += std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / std::numbers::pi;
                count += 1.0;
            }
        }
    }
    double mean() const { return count > 0.0 ? sum / count : 0.0; }
};

class PoseRun {
public:
    PoseRun(const PosePlan& plan, const std::function<bool(double)>& goOn)
        : plan_(plan), goOn_(goOn), seconds_(plan.model->duration(plan.animation)) {
        const int most = *std::max_element(plan.poses.begin(), plan.poses.end());
        bakes_ = most + plan.tests + 2;
    }

    AoStatus prepare();
    Result<PoseRow> row(int poses) const;

private:
    Result<Baked> bakeAt(double time, std::uint32_t seed);
    double keyTime(int key, int poses) const {
        return poses < 2 ? 0.0 : seconds_ * double(key) / double(poses - 1);
    }
    double testTime(int test) const {
        return seconds_ * (double(test) + 0.5) / double(plan_.tests);
    }

    const PosePlan& plan_;
    const std::function<bool(double)>& goOn_;
    double seconds_;
    int bakes_ = 0; ///< about so many in all
    int done_ = 0;
    std::map<double, Baked> keys_; ///< by time
    std::vector<Baked> truths_;    ///< by test
    Baked rest_;
    double noise_ = 0.0;
    double noiseAngle_ = 0.0;
};

Result<Baked> PoseRun::bakeAt(double time, std::uint32_t seed) {
    if (!goOn_(double(done_++) / double(bakes_))) {
        return AoStatus(StatusCode::Cancelled, "the run was cancelled");
    }
    const Result<PosedModel, LoadError> model = plan_.model->posedAt(plan_.animation, time);
    if (!model) {
        return AoStatus(StatusCode::InvalidPosition, model.error().sentence);
    }
    return baked(*model, plan_.rays, seed);
}

AoStatus PoseRun::prepare() {
    for (const int poses : plan_.poses) {
        for (int key = 0; key < poses; ++key) {
            const double time = keyTime(key, poses);
            if (keys_.count(time) == 0) {
                Result<Baked> values = bakeAt(time, 0);
                if (!values) {
                    return values.status();
                }
                keys_[time] = std::move(*values);
            }
        }
    }
    constexpr std::uint32_t seed = 1;
    for (int test = 0; test < plan_.tests; ++test) {
        Result<Baked> values = bakeAt(testTime(test), seed);
        if (!values) {
            return values.status();
        }
        truths_.push_back(std::move(*values));
    }
    const std::size_t none = plan_.model->animations(); // no such animation: the model at rest
    const Result<PosedModel, LoadError> still = plan_.model->posedAt(none, 0.0);
    if (!still) {
        return {StatusCode::InvalidPosition, still.error().sentence};
    }
    const int middle = plan_.tests / 2;
    Result<Baked> rest = baked(*still, plan_.rays, 0);
    Result<Baked> again = bakeAt(testTime(middle), seed + 1);
    if (!rest || !again) {
        return rest ? again.status() : rest.status();
    }
    rest_ = std::move(*rest);
    Error noise;
    noise.add(again->visibility, truths_[static_cast<std::size_t>(middle)].visibility);
    noise_ = noise.rmse();
    Angles noiseAngle;
    noiseAngle.add(again->bentNormal, truths_[static_cast<std::size_t>(middle)]);
    noiseAngle_ = noiseAngle.mean();
    return {};
}

Result<PoseRow> PoseRun::row(int poses) const {
    std::vector<float> times;
    std::vector<Values> values;
    std::vector<std::vector<glm::vec3>> normals;
    std::vector<std::vector<float>> parameters;
    for (int key = 0; key < poses; ++key) {
        times.push_back(static_cast<float>(keyTime(key, poses)));
        values.push_back(keys_.at(keyTime(key, poses)).visibility);
        normals.push_back(keys_.at(keyTime(key, poses)).bentNormal);
        parameters.push_back(plan_.model->parameters(plan_.animation, keyTime(key, poses)));
    }
    Error rest;
    Error byTime;
    Error byParameters;
    Angles restAngle;
    Angles byTimeAngle;
    for (int test = 0; test < plan_.tests; ++test) {
        const Baked& fresh = truths_[static_cast<std::size_t>(test)];
        const Values& truth = fresh.visibility;
        const auto linear = bake::poseWeightsAt(times, static_cast<float>(testTime(test)));
        const auto fitted = bake::poseWeightsFor(
            parameters, plan_.model->parameters(plan_.animation, testTime(test)));
        if (!fitted) {
            return fitted.status();
        }
        rest.add(rest_.visibility, truth);
        restAngle.add(rest_.bentNormal, fresh);
        byTimeAngle.add(*bake::blendPoseNormals(normals, linear), fresh);
        byTime.add(*bake::blendPoses(values, linear), truth);
        byParameters.add(*bake::blendPoses(values, *fitted), truth);
    }
    return PoseRow{plan_.name,  rest_.visibility.size(), poses,
                   rest.rmse(), byTime.rmse(),           byParameters.rmse(),
                   noise_,      restAngle.mean(),        byTimeAngle.mean(),
                   noiseAngle_};
}

} // namespace

Result<std::vector<PoseRow>> runPosePlan(const PosePlan& plan,
                                         const std::function<bool(double done)>& goOn) {
    PoseRun run(plan, goOn);
    if (AoStatus status = run.prepare(); !status) {
        return status;
    }
    std::vector<PoseRow> rows;
    for (const int poses : plan.poses) {
        const Result<PoseRow> row = run.row(poses);
        if (!row) {
            return row.status();
        }
        rows.push_back(*row);
    }
    return rows;
}

std::string poseMarkdown(const std::vector<PoseRow>& rows) {
    std::string text = "| model | vertices | poses | at rest | by time | by parameters | noise | "
                       "bent normal: at rest | by time | noise |\n"
                       "|---|---|---|---|---|---|---|---|---|---|\n";
    for (const PoseRow& row : rows) {
        std::array<char, 160> numbers{};
        std::snprintf(numbers.data(), numbers.size(),
                      "%d | %.4f | %.4f | %.4f | %.4f | %.1f° | %.1f° | %.1f° |", row.poses,
                      row.rest, row.byTime, row.byParameters, row.noise, row.restAngle,
                      row.byTimeAngle, row.noiseAngle);
        text +=
            "| " + row.name + " | " + std::to_string(row.vertices) + " | " + numbers.data() + "\n";
    }
    return text;
}

} // namespace aolib::bench
