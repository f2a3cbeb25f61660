#pragma once

#include <string_view>

namespace aolib::host {

// The texts of the files under tools/host/shaders, embedded at build time.
extern const std::string_view surfaceVertexShader;
extern const std::string_view surfaceFragmentShader;
extern const std::string_view skyVertexShader;
extern const std::string_view skyFragmentShader;
// Without a `#version` line: environmentShader() comes before litFragmentShader and
// litSkyFragmentShader.
extern const std::string_view litVertexShader;
extern const std::string_view litFragmentShader;
extern const std::string_view litSkyFragmentShader;
extern const std::string_view sunDepthVertexShader;
extern const std::string_view sunDepthFragmentShader;

} // namespace aolib::host
