#include "app/ResolveOptions.h"

namespace aolib::app {

namespace {

/// What the library takes for a radius of 0, as a share of the diagonal.
constexpr double kDefaultRadius = 0.1;

} // namespace

Options resolveOptions(const View& view, const OptionFlags& flags) {
    Options options = view.options;
    flags.apply(options, view.diagonal);
    if (!(options.radius > 0.0F)) {
        options.radius = static_cast<float>(kDefaultRadius * view.diagonal);
    }
    return options;
}

} // namespace aolib::app
