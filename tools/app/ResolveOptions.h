#pragma once

#include "app/OptionFlags.h"
#include "app/ViewFlags.h"

namespace aolib::app {

/// The options of a view: the case file's, overridden by flags. The radius comes out in world units
/// and above 0, so that the library and the truth take the same. Where no estimator is named, the
/// most accurate one.
Options resolveOptions(const View& view, const OptionFlags& flags);

} // namespace aolib::app
