#pragma once

#include <string_view>

namespace aolib::host {

// The texts of the files under tools/host/shaders, embedded at build time.
extern const std::string_view surfaceVertexShader;
extern const std::string_view surfaceFragmentShader;
extern const std::string_view skyVertexShader;
extern const std::string_view skyFragmentShader;

} // namespace aolib::host
