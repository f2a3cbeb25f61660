#pragma once

#include <cstdint>

namespace aolib {

/// Identifies a view of the host: a window, a half of a split screen, an eye. The host chooses the
/// numbers; a host with one view uses the default 0. Since 0.1.
enum class ViewId : std::uint32_t {};

} // namespace aolib
