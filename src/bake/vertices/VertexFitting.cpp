#include "bake/vertices/VertexFitting.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include <glm/geometric.hpp>

namespace aolib::bake {

namespace {

constexpr int mostIterations = 200;
/// The residual's share of the right side's length at which a fit is good enough.
constexpr double closeEnough = 1e-5;

using Values = std::vector<glm::dvec4>;

std::array<std::uint32_t, 3> findCorners(const BakeGeometry& geometry, const VertexWeld& weld,
                                         const TriangleName& name) {
    const std::vector<std::uint32_t>& index = geometry.scene().surfaces[name.surface].indices;
    const std::vector<std::uint32_t>& number = weld.number[name.surface];
    const std::size_t first = std::size_t{name.triangle} * 3;
    return {number[index[first]], number[index[first + 1]], number[index[first + 2]]};
}

/// The normal equations, never stored: A = B^T D B + smoothness * L.
class FitMatrix {
public:
    FitMatrix(const BakeGeometry& geometry, const VertexWeld& weld,
              std::span<const SurfaceSample> samples, double smoothness)
        : samples_(samples), smoothness_(smoothness / 3.0), size_(weld.points.size()) {
        corners_.reserve(samples.size());
        for (const SurfaceSample& sample : samples) {
            corners_.push_back(findCorners(geometry, weld, sample.triangle));
        }
    }

    static std::array<double, 3> weights(const SurfaceSample& sample) {
        return {1.0 - double{sample.b1} - double{sample.b2}, double{sample.b1}, double{sample.b2}};
    }

    Values rightSide(std::span<const glm::vec4> values) const {
        Values result(size_, glm::dvec4(0.0));
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const std::array<double, 3> b = weights(samples_[i]);
            for (std::size_t k = 0; k < 3; ++k) {
                result[corners_[i][k]] += b[k] * double{samples_[i].area} * glm::dvec4(values[i]);
            }
        }
        return result;
    }

    Values diagonal() const {
        Values result(size_, glm::dvec4(0.0));
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const std::array<double, 3> b = weights(samples_[i]);
            const double area{samples_[i].area};
            for (std::size_t k = 0; k < 3; ++k) {
                result[corners_[i][k]] += glm::dvec4(area * (b[k] * b[k] + 2.0 * smoothness_));
            }
        }
        return result;
    }

    void multiply(const Values& x, Values& result) const {
        std::fill(result.begin(), result.end(), glm::dvec4(0.0));
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const std::array<double, 3> b = weights(samples_[i]);
            const double area{samples_[i].area};
            const auto& c = corners_[i];
            const glm::dvec4 mean = b[0] * x[c[0]] + b[1] * x[c[1]] + b[2] * x[c[2]];
            const glm::dvec4 sum = x[c[0]] + x[c[1]] + x[c[2]];
            for (std::size_t k = 0; k < 3; ++k) {
                result[c[k]] += area * (b[k] * mean + smoothness_ * (3.0 * x[c[k]] - sum));
            }
        }
    }

private:
    std::span<const SurfaceSample> samples_;
    std::vector<std::array<std::uint32_t, 3>> corners_;
    double smoothness_; ///< of each of a triangle's three edges
    std::size_t size_;
};

glm::dvec4 dotAll(const Values& a, const Values& b) {
    glm::dvec4 sum(0.0);
    for (std::size_t i = 0; i < a.size(); ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

/// Component by component a / b, 0 where b is 0.
glm::dvec4 quotient(const glm::dvec4& a, const glm::dvec4& b) {
    glm::dvec4 result(0.0);
    for (int k = 0; k < 4; ++k) {
        result[k] = b[k] != 0.0 ? a[k] / b[k] : 0.0;
    }
    return result;
}

/// Conjugate gradients with the diagonal as preconditioner, four right sides at once.
void solve(const FitMatrix& matrix, const Values& right, Values& x) {
    const Values diagonal = matrix.diagonal();
    Values product(x.size());
    matrix.multiply(x, product);
    Values residual(x.size());
    Values preconditioned(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        residual[i] = right[i] - product[i];
        preconditioned[i] = quotient(residual[i], diagonal[i]);
    }
    Values direction = preconditioned;
    glm::dvec4 size = dotAll(residual, preconditioned);
    const glm::dvec4 wanted = closeEnough * closeEnough * dotAll(right, right);
    for (int step = 0; step < mostIterations; ++step) {
        if (glm::all(glm::lessThanEqual(dotAll(residual, residual), wanted))) {
            return;
        }
        matrix.multiply(direction, product);
        const glm::dvec4 length = quotient(size, dotAll(direction, product));
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += length * direction[i];
            residual[i] -= length * product[i];
            preconditioned[i] = quotient(residual[i], diagonal[i]);
        }
        const glm::dvec4 next = dotAll(residual, preconditioned);
        const glm::dvec4 turn = quotient(next, size);
        for (std::size_t i = 0; i < x.size(); ++i) {
            direction[i] = preconditioned[i] + turn * direction[i];
        }
        size = next;
    }
}

} // namespace

std::vector<glm::vec4> meanAboutVertices(const BakeGeometry& geometry, const VertexWeld& weld,
                                         std::span<const SurfaceSample> samples,
                                         std::span<const glm::vec4> values) {
    Values sums(weld.points.size(), glm::dvec4(0.0));
    std::vector<int> counts(weld.points.size(), 0);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        for (const std::uint32_t corner : findCorners(geometry, weld, samples[i].triangle)) {
            sums[corner] += glm::dvec4(values[i]);
            ++counts[corner];
        }
    }
    std::vector<glm::vec4> result(sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i) {
        result[i] = glm::vec4(sums[i] / static_cast<double>(std::max(1, counts[i])));
    }
    return result;
}

std::vector<glm::vec4> fitVertices(const BakeGeometry& geometry, const VertexWeld& weld,
                                   std::span<const SurfaceSample> samples,
                                   std::span<const glm::vec4> values, double smoothness) {
    const std::vector<glm::vec4> start = meanAboutVertices(geometry, weld, samples, values);
    Values x(start.begin(), start.end());
    const FitMatrix matrix(geometry, weld, samples, smoothness);
    solve(matrix, matrix.rightSide(values), x);
    return {x.begin(), x.end()};
}

std::vector<glm::vec4> fitIntegrals(const BakeGeometry& geometry, const VertexWeld& weld,
                                    const std::vector<glm::dvec4>& right,
                                    const std::vector<glm::vec4>& start, double smoothness) {
    const std::vector<SurfaceSample> samples = edgeMiddles(geometry);
    Values x(start.begin(), start.end());
    solve(FitMatrix(geometry, weld, samples, smoothness), right, x);
    return {x.begin(), x.end()};
}

Result<std::vector<glm::vec4>> weldedValues(const BakeGeometry& geometry, const VertexWeld& weld,
                                            const VertexOptions& options,
                                            const ValuesAt& valuesAt) {
    if (options.fit == VertexFit::Direct) {
        return valuesAt(weld.points);
    }
    const bool mean = options.fit == VertexFit::TriangleMean;
    const std::vector<SurfaceSample> samples =
        mean ? triangleCentres(geometry) : spreadSamples(geometry, double{options.density});
    std::vector<SurfacePoint> places;
    places.reserve(samples.size());
    for (const SurfaceSample& sample : samples) {
        SurfacePoint place = *geometry.point(sample.triangle, double{sample.b1}, double{sample.b2});
        place.normal = mean ? place.plane : place.normal; // as GPU Gems, 17.2, does
        places.push_back(place);
    }
    const Result<std::vector<glm::vec4>> values = valuesAt(places);
    if (!values) {
        return values;
    }
    return mean ? meanAboutVertices(geometry, weld, samples, *values)
                : fitVertices(geometry, weld, samples, *values, double{options.smoothness});
}

} // namespace aolib::bake
