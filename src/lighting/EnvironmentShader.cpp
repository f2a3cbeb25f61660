#include "lighting/EnvironmentShader.h"

#include <aolib/lighting/EnvironmentLight.h>

namespace aolib::lighting {

std::string_view environmentShader() {
    return kLightingShaders[0].text;
}

} // namespace aolib::lighting
