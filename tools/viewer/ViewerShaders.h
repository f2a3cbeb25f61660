#pragma once

#include <string_view>

namespace aolib::viewer {

// The texts of the files under tools/viewer/shaders, embedded at build time.
extern const std::string_view wholeVertexShader;
extern const std::string_view tracedFragmentShader;

} // namespace aolib::viewer
