#include "app/Comparison.h"

#include <utility>

#include "image/DifferencePicture.h"

namespace aolib::app {

Result<ErrorAgainstTruth, Failure> compareWithTruth(const FloatImage& visibility,
                                                    const Truth& truth) {
    const Result<Metrics, ImageError> metrics = compareImages(visibility, truth.visibility);
    if (!metrics) {
        return Failure{ExitCode::Failed, "comparing with ray tracing: " + metrics.error().message};
    }
    return ErrorAgainstTruth{*metrics, truth.noise, truth.rays};
}

Result<ByteImage, Failure> differenceFromTruth(const FloatImage& visibility, const Truth& truth) {
    Result<ByteImage, ImageError> picture =
        differencePicture(visibility, truth.visibility, kDifferenceScale);
    if (!picture) {
        return Failure{ExitCode::Failed, "comparing with ray tracing: " + picture.error().message};
    }
    return std::move(*picture);
}

} // namespace aolib::app
