#include "bench/poses/PoseRun.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <utility>

#include <aolib/bake/AbstractBaker.h>
#include <aolib/bake/PoseBlend.h>

namespace aolib::bench {

namespace {

using Values = std::vector<float>;

Result<Values> baked(const Model& model, int rays, std::uint32_t seed) {
    bake::BakeScene scene;
    for (const ModelMesh& mesh : model.meshes) {
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
    Values all;
    for (const bake::BakedVertices& piece : *vertices) {
        all.insert(all.end(), piece.visibility.begin(), piece.visibility.end());
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

class PoseRun {
public:
    PoseRun(const PosePlan& plan, const std::function<bool(double)>& goOn)
        : plan_(plan), goOn_(goOn), seconds_(plan.model->duration(plan.animation)) {
        const int most = *std::max_element(plan.poses.begin(), plan.poses.end());
        bakes_ = most + plan.tests + 2;
    }

    Status prepare();
    Result<PoseRow> row(int poses) const;

private:
    Result<Values> bakeAt(double time, std::uint32_t seed);
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
    std::map<double, Values> keys_; ///< by time
    std::vector<Values> truths_;    ///< by test
    Values rest_;
    double noise_ = 0.0;
};

Result<Values> PoseRun::bakeAt(double time, std::uint32_t seed) {
    if (!goOn_(double(done_++) / double(bakes_))) {
        return Status(StatusCode::Cancelled, "the run was cancelled");
    }
    const Loaded<Model> model = plan_.model->at(plan_.animation, time);
    if (!model) {
        return Status(StatusCode::InvalidPosition, model.sentence());
    }
    return baked(*model, plan_.rays, seed);
}

Status PoseRun::prepare() {
    for (const int poses : plan_.poses) {
        for (int key = 0; key < poses; ++key) {
            const double time = keyTime(key, poses);
            if (keys_.count(time) == 0) {
                Result<Values> values = bakeAt(time, 0);
                if (!values) {
                    return values.status();
                }
                keys_[time] = std::move(*values);
            }
        }
    }
    constexpr std::uint32_t seed = 1;
    for (int test = 0; test < plan_.tests; ++test) {
        Result<Values> values = bakeAt(testTime(test), seed);
        if (!values) {
            return values.status();
        }
        truths_.push_back(std::move(*values));
    }
    const std::size_t none = plan_.model->animations(); // no such animation: the model at rest
    const Loaded<Model> still = plan_.model->at(none, 0.0);
    if (!still) {
        return {StatusCode::InvalidPosition, still.sentence()};
    }
    Result<Values> rest = baked(*still, plan_.rays, 0);
    Result<Values> again = bakeAt(testTime(0), seed + 1);
    if (!rest || !again) {
        return rest ? again.status() : rest.status();
    }
    rest_ = std::move(*rest);
    Error noise;
    noise.add(*again, truths_[0]);
    noise_ = noise.rmse();
    return {};
}

Result<PoseRow> PoseRun::row(int poses) const {
    std::vector<float> times;
    std::vector<Values> values;
    std::vector<std::vector<float>> parameters;
    for (int key = 0; key < poses; ++key) {
        times.push_back(static_cast<float>(keyTime(key, poses)));
        values.push_back(keys_.at(keyTime(key, poses)));
        parameters.push_back(plan_.model->parameters(plan_.animation, keyTime(key, poses)));
    }
    Error rest;
    Error byTime;
    Error byParameters;
    for (int test = 0; test < plan_.tests; ++test) {
        const Values& truth = truths_[static_cast<std::size_t>(test)];
        const auto linear = bake::poseWeightsAt(times, static_cast<float>(testTime(test)));
        const auto fitted = bake::poseWeightsFor(
            parameters, plan_.model->parameters(plan_.animation, testTime(test)));
        if (!fitted) {
            return fitted.status();
        }
        rest.add(rest_, truth);
        byTime.add(*bake::blendPoses(values, linear), truth);
        byParameters.add(*bake::blendPoses(values, *fitted), truth);
    }
    return PoseRow{plan_.name,    rest_.size(),        poses, rest.rmse(),
                   byTime.rmse(), byParameters.rmse(), noise_};
}

} // namespace

Result<std::vector<PoseRow>> runPosePlan(const PosePlan& plan,
                                         const std::function<bool(double done)>& goOn) {
    PoseRun run(plan, goOn);
    if (Status status = run.prepare(); !status) {
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
    std::string text = "| model | vertices | poses | at rest | by time | by parameters | noise |\n"
                       "|---|---|---|---|---|---|---|\n";
    for (const PoseRow& row : rows) {
        std::array<char, 160> numbers{};
        std::snprintf(numbers.data(), numbers.size(), "%d | %.4f | %.4f | %.4f | %.4f |", row.poses,
                      row.rest, row.byTime, row.byParameters, row.noise);
        text +=
            "| " + row.name + " | " + std::to_string(row.vertices) + " | " + numbers.data() + "\n";
    }
    return text;
}

} // namespace aolib::bench
