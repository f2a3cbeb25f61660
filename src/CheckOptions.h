#pragma once

#include <aolib/Options.h>
#include <aolib/Status.h>

namespace aolib {

/// Ok if every option lies in its range. Errors: InvalidOption, naming the option, its value and
/// its range.
AoStatus checkOptions(const Options& options);

} // namespace aolib
