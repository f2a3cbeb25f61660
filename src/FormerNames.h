#pragma once

#include <aolib/Options.h>
#include <aolib/Statistics.h>

namespace aolib {

/// Switches off what a host switches off by an option's former name.
void applyFormerNames(CubeMapOptions& options);
/// Fills in the statistics' former names.
void setFormerNames(Statistics& statistics);

} // namespace aolib
