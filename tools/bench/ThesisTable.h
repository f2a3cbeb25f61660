#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <aolib/Options.h>

namespace aolib::bench {

/// What a figure of the thesis varies.
enum class ThesisFigure {
    FaceSize,   ///< build time and memory over texels along a face's edge
    Directions, ///< build time over directions (layered intervals: slices)
    Steps,      ///< build time over steps per direction
    CubeMaps,   ///< frame time over cube maps projected
};

/// One measurement of a figure.
struct ThesisSetting {
    ThesisFigure figure = ThesisFigure::FaceSize;
    Estimator estimator = Estimator::HorizonSplit;
    int faceSize = 512;
    int directions = 16; ///< or slices
    int steps = 16;
    int cubeMaps = 1;

    /// What the figure varies.
    int value() const;
    /// Options for the library, but for the radius; nothing is placed but by hand.
    Options options() const;
};

/// All figures, in the thesis's order.
const std::vector<ThesisFigure>& thesisFigures();
/// "face-size", for flags and files.
std::string_view figureName(ThesisFigure figure);
/// What its x axis says.
std::string_view figureAxis(ThesisFigure figure);
/// "horizon-split", as in options.
std::string_view estimatorName(Estimator estimator);

/// The measurements of a figure. @param quick  smaller faces and fewer of them.
std::vector<ThesisSetting> thesisSettings(ThesisFigure figure, Estimator estimator, bool quick);

} // namespace aolib::bench
