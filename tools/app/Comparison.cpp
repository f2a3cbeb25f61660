#include "app/Comparison.h"

#include <utility>

#include "image/DifferencePicture.h"

namespace aolib::app {

Outcome<ErrorAgainstTruth> compareWithTruth(const FloatImage& visibility, const Truth& truth) {
    const ImageResult<Metrics> metrics = compareImages(visibility, truth.visibility);
    if (!metrics) {
        return Failure{ExitCode::Failed, "comparing with ray tracing: " + metrics.message()};
    }
    return ErrorAgainstTruth{*metrics, truth.noise, truth.rays};
}

Outcome<ByteImage> differenceFromTruth(const FloatImage& visibility, const Truth& truth) {
    ImageResult<ByteImage> picture =
        differencePicture(visibility, truth.visibility, kDifferenceScale);
    if (!picture) {
        return Failure{ExitCode::Failed, "comparing with ray tracing: " + picture.message()};
    }
    return std::move(*picture);
}

} // namespace aolib::app
