#include <aolib/bake/PoseBlend.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

namespace aolib::bake {

namespace {

/// What near poses are preferred by, of their squared distances.
constexpr double nearness = 1e-3;

using Matrix = std::vector<std::vector<double>>;

/// Solves a symmetric positive definite system by elimination with pivots.
std::vector<double> solved(Matrix matrix, std::vector<double> right) {
    const std::size_t size = right.size();
    for (std::size_t column = 0; column < size; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column + 1; row < size; ++row) {
            pivot = std::abs(matrix[row][column]) > std::abs(matrix[pivot][column]) ? row : pivot;
        }
        std::swap(matrix[column], matrix[pivot]);
        std::swap(right[column], right[pivot]);
        for (std::size_t row = column + 1; row < size; ++row) {
            const double factor = matrix[row][column] / matrix[column][column];
            for (std::size_t i = column; i < size; ++i) {
                matrix[row][i] -= factor * matrix[column][i];
            }
            right[row] -= factor * right[column];
        }
    }
    for (std::size_t row = size; row-- > 0;) {
        for (std::size_t i = row + 1; i < size; ++i) {
            right[row] -= matrix[row][i] * right[i];
        }
        right[row] /= matrix[row][row];
    }
    return right;
}

AoStatus check(std::span<const std::vector<float>> poses, std::span<const float> wanted) {
    const auto finite = [](float value) { return std::isfinite(value); };
    if (poses.empty()) {
        return {StatusCode::InvalidOption, "there is no pose to blend"};
    }
    for (std::size_t i = 0; i < poses.size(); ++i) {
        if (poses[i].size() != wanted.size()) {
            return {StatusCode::InvalidOption,
                    "pose " + std::to_string(i) + " has " + std::to_string(poses[i].size()) +
                        " parameters, wanted are " + std::to_string(wanted.size())};
        }
        if (!std::all_of(poses[i].begin(), poses[i].end(), finite)) {
            return {StatusCode::InvalidOption,
                    "a parameter of pose " + std::to_string(i) + " is not finite"};
        }
    }
    if (!std::all_of(wanted.begin(), wanted.end(), finite)) {
        return {StatusCode::InvalidOption, "a parameter that is wanted is not finite"};
    }
    return {};
}

} // namespace

std::vector<float> poseWeightsAt(std::span<const float> times, float time) {
    std::vector<float> weights(times.size(), 0.0F);
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    if (after == times.begin() || after == times.end()) {
        (after == times.begin() ? weights.front() : weights.back()) = 1.0F;
        return weights;
    }
    const auto second = static_cast<std::size_t>(after - times.begin());
    const float part = (time - times[second - 1]) / (times[second] - times[second - 1]);
    weights[second - 1] = 1.0F - part;
    weights[second] = part;
    return weights;
}

Result<std::vector<float>> poseWeightsFor(std::span<const std::vector<float>> poses,
                                          std::span<const float> wanted) {
    if (AoStatus status = check(poses, wanted); !status) {
        return status;
    }
    const std::size_t count = poses.size();
    // Of the differences to what is wanted: sums to 1 make their weighted sum the error.
    Matrix products(count, std::vector<double>(count, 0.0));
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < count; ++j) {
            for (std::size_t k = 0; k < wanted.size(); ++k) {
                products[i][j] += (double{poses[i][k]} - double{wanted[k]}) *
                                  (double{poses[j][k]} - double{wanted[k]});
            }
        }
    }
    std::vector<float> weights(count, 0.0F);
    for (std::size_t i = 0; i < count; ++i) {
        if (!(products[i][i] > 0.0)) {
            weights[i] = 1.0F;
            return weights;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        products[i][i] *= 1.0 + nearness;
    }
    const std::vector<double> solution = solved(products, std::vector<double>(count, 1.0));
    double sum = 0.0;
    for (const double value : solution) {
        sum += value;
    }
    for (std::size_t i = 0; i < count; ++i) {
        weights[i] = static_cast<float>(solution[i] / sum);
    }
    return weights;
}

namespace {

/// The weighted sum of what vertices have in poses.
template <typename T>
Result<std::vector<T>> weightedSum(std::span<const std::vector<T>> poses,
                                   std::span<const float> weights) {
    if (poses.empty() || poses.size() != weights.size()) {
        return AoStatus(StatusCode::InvalidOption, std::to_string(weights.size()) +
                                                       " weights for " +
                                                       std::to_string(poses.size()) + " poses");
    }
    std::vector<T> sum(poses[0].size(), T(0.0F));
    for (std::size_t pose = 0; pose < poses.size(); ++pose) {
        if (poses[pose].size() != sum.size()) {
            return AoStatus(StatusCode::InvalidOption, "pose " + std::to_string(pose) + " has " +
                                                           std::to_string(poses[pose].size()) +
                                                           " vertices, the first has " +
                                                           std::to_string(sum.size()));
        }
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += weights[pose] * poses[pose][i];
        }
    }
    return sum;
}

} // namespace

Result<std::vector<float>> blendPoses(std::span<const std::vector<float>> poses,
                                      std::span<const float> weights) {
    Result<std::vector<float>> sum = weightedSum(poses, weights);
    if (sum) {
        for (float& value : *sum) {
            value = std::clamp(value, 0.0F, 1.0F);
        }
    }
    return sum;
}

Result<std::vector<glm::vec3>> blendPoseNormals(std::span<const std::vector<glm::vec3>> poses,
                                                std::span<const float> weights) {
    Result<std::vector<glm::vec3>> sum = weightedSum(poses, weights);
    if (sum) {
        const auto most = std::max_element(weights.begin(), weights.end()) - weights.begin();
        const std::vector<glm::vec3>& nearest = poses[static_cast<std::size_t>(most)];
        for (std::size_t i = 0; i < sum->size(); ++i) {
            const float length = glm::length((*sum)[i]);
            (*sum)[i] = length > 1e-6F ? (*sum)[i] / length : nearest[i];
        }
    }
    return sum;
}

} // namespace aolib::bake
