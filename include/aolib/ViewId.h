#pragma once

#include <cstdint>

namespace aolib {

/// Names a view of the host's: a window, a half of a split screen, an eye. The host chooses the
/// numbers; a host with one view needs none. Since 0.1.
enum class ViewId : std::uint32_t {};

} // namespace aolib
