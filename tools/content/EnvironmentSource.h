#pragma once

#include <string>

#include <aolib/lighting/EnvironmentMap.h>

#include "content/Loaded.h"

namespace aolib {

/// The generated environment of this name, or else the Radiance file (.hdr) of this path.
Loaded<lighting::EnvironmentMap> openEnvironment(const std::string& nameOrPath);

} // namespace aolib
