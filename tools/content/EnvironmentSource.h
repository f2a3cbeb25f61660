#pragma once

#include <string>

#include <aolib/lighting/EnvironmentMap.h>

#include "content/LoadError.h"

namespace aolib {

/// The generated environment of this name, or else the Radiance file (.hdr) of this path.
Result<lighting::EnvironmentMap, LoadError> openEnvironment(const std::string& nameOrPath);

} // namespace aolib
