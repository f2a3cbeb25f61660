#include "Figures.h"

#include <algorithm>
#include <cmath>

#include "reference/PictureTracer.h"

namespace aolib {

double percentile(std::vector<double>& values, double share) {
    if (values.empty()) {
        return 0.0;
    }
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

Change changeOf(const std::vector<float>& before, const std::vector<float>& after) {
    EXPECT_EQ(before.size(), after.size());
    std::vector<double> differences;
    Change change;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if ((before[i] < 0.0F) != (after[i] < 0.0F)) {
            change.missing += 1.0 / static_cast<double>(before.size());
        } else if (before[i] >= 0.0F) {
            differences.push_back(std::abs(double{after[i]} - double{before[i]}));
            change.max = std::max(change.max, differences.back());
        }
    }
    EXPECT_FALSE(differences.empty()) << "nothing was compared";
    const auto above = std::count_if(differences.begin(), differences.end(),
                                     [](double d) { return d > 1.0 / 255.0 + 1e-6; });
    change.above = static_cast<double>(above) /
                   static_cast<double>(std::max<std::size_t>(differences.size(), 1));
    change.p99 = percentile(differences, 0.99);
    return change;
}

Error errorOf(const Shot& shot, const Model& model, const Options& options, int rays) {
    Error error;
    const auto scene = RayScene::create(model.flattened());
    EXPECT_TRUE(scene.ok()) << scene.status().message();
    PictureSettings settings;
    settings.trace.rays = rays;
    settings.trace.radius = double{options.radius};
    settings.trace.falloff = options.falloff;
    const auto truth = tracePicture(*scene,
                                    {glm::dmat4(shot.view), glm::dmat4(shot.projection),
                                     shot.picture.width, shot.picture.height},
                                    settings);
    EXPECT_TRUE(truth.ok()) << truth.status().message();
    error.truth = truth->visibility;
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < error.truth.size(); ++i) {
        const double ours{shot.picture.visibility[i]};
        const double other{error.truth[i]};
        if ((ours < 0.0) != (other < 0.0)) {
            error.mismatched += 1.0 / static_cast<double>(error.truth.size());
        } else if (ours >= 0.0) {
            squares += (ours - other) * (ours - other);
            error.mean += ours - other;
            count += 1.0;
        }
    }
    EXPECT_GT(count, 0.0) << "nothing was compared";
    error.mean /= std::max(count, 1.0);
    error.rmse =
        std::sqrt(std::max(squares / std::max(count, 1.0) - truth->noise * truth->noise, 0.0));
    return error;
}

} // namespace aolib
