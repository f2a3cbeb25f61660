#include "bench/ThesisTable.h"

#include <algorithm>

#include <aolib/OptionFields.h>

namespace aolib::bench {

namespace {

constexpr int kQuickDivisor = 4; ///< of face sizes

std::vector<int> valuesOf(ThesisFigure figure) {
    switch (figure) {
    case ThesisFigure::FaceSize:
        return {256, 512, 1024};
    case ThesisFigure::Directions:
    case ThesisFigure::Steps:
        return {4, 8, 12, 16, 24, 32};
    case ThesisFigure::CubeMaps:
        return {1, 2, 5, 10, 15, 20, 25};
    }
    return {};
}

/// What the layered estimator starts from: its default has fewer slices than the thesis has
/// directions.
ThesisSetting startingPoint(ThesisFigure figure, Estimator estimator) {
    ThesisSetting setting;
    setting.figure = figure;
    setting.estimator = estimator;
    if (estimator != Estimator::HorizonSplit) {
        setting.directions = LayeredIntervalsOptions().slices;
        setting.steps = LayeredIntervalsOptions().steps;
    }
    if (figure == ThesisFigure::CubeMaps) { // a frame's cost hardly depends on the faces' size
        setting.faceSize = estimator == Estimator::HorizonSplit ? 512 : 128;
    }
    return setting;
}

} // namespace

int ThesisSetting::value() const {
    switch (figure) {
    case ThesisFigure::FaceSize:
        return faceSize;
    case ThesisFigure::Directions:
        return directions;
    case ThesisFigure::Steps:
        return steps;
    case ThesisFigure::CubeMaps:
        return cubeMaps;
    }
    return 0;
}

Options ThesisSetting::options() const {
    Options options;
    options.estimator = estimator;
    options.frameBudget = 0.0F;
    options.cubeMaps.place = false;
    options.cubeMaps.faceSize = faceSize;
    options.cubeMaps.nearest = cubeMaps;
    options.horizonSplit = {.directions = directions, .steps = steps};
    options.layeredIntervals.slices = directions;
    options.layeredIntervals.steps = steps;
    return options;
}

const std::vector<ThesisFigure>& thesisFigures() {
    static const std::vector<ThesisFigure> all{ThesisFigure::FaceSize, ThesisFigure::Directions,
                                               ThesisFigure::Steps, ThesisFigure::CubeMaps};
    return all;
}

std::string_view figureName(ThesisFigure figure) {
    switch (figure) {
    case ThesisFigure::FaceSize:
        return "face-size";
    case ThesisFigure::Directions:
        return "directions";
    case ThesisFigure::Steps:
        return "steps";
    case ThesisFigure::CubeMaps:
        return "cube-maps";
    }
    return "";
}

std::string_view figureAxis(ThesisFigure figure) {
    switch (figure) {
    case ThesisFigure::FaceSize:
        return "texels along a face's edge";
    case ThesisFigure::Directions:
        return "directions (layered intervals: slices) per texel";
    case ThesisFigure::Steps:
        return "steps per direction";
    case ThesisFigure::CubeMaps:
        return "cube maps projected";
    }
    return "";
}

std::string_view estimatorName(Estimator estimator) {
    const auto found = std::find_if(kEstimatorChoices.begin(), kEstimatorChoices.end(),
                                    [&](const auto& choice) { return choice.value == estimator; });
    return found == kEstimatorChoices.end() ? "" : found->name;
}

std::vector<ThesisSetting> thesisSettings(ThesisFigure figure, Estimator estimator, bool quick) {
    std::vector<ThesisSetting> settings;
    for (const int value : valuesOf(figure)) {
        ThesisSetting setting = startingPoint(figure, estimator);
        switch (figure) {
        case ThesisFigure::FaceSize:
            setting.faceSize = value;
            break;
        case ThesisFigure::Directions:
            setting.directions = value;
            break;
        case ThesisFigure::Steps:
            setting.steps = value;
            break;
        case ThesisFigure::CubeMaps:
            setting.cubeMaps = value;
            break;
        }
        setting.faceSize /= quick ? kQuickDivisor : 1;
        settings.push_back(setting);
    }
    return settings;
}

} // namespace aolib::bench
