#pragma once

#include <string_view>
#include <vector>

#include <aolib/lighting/EnvironmentMap.h>

namespace aolib {

/// Light that needs no file: 512 x 256 texels, the same every time.
struct GeneratedEnvironment {
    const char* name;
    const char* description; ///< one line
    lighting::EnvironmentMap (*build)();
};

/// Every generated environment, in the order in which tools list them.
const std::vector<GeneratedEnvironment>& generatedEnvironments();

/// The environment of a name, or nullptr.
const GeneratedEnvironment* findGeneratedEnvironment(std::string_view name);

} // namespace aolib
