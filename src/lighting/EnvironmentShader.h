#pragma once

#include <cstddef>
#include <string_view>

namespace aolib {

/// A text as the build embeds it, includes resolved.
struct LightingShader {
    std::string_view name;  ///< path below shaders/
    std::string_view files; ///< the files it was made of; `#line` numbers them from 0
    std::string_view text;
};

extern const LightingShader kLightingShaders[];
extern const std::size_t kLightingShaderCount;

} // namespace aolib
