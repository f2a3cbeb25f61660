#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <aolib/Scene.h>
#include <aolib/Status.h>

namespace aolib {

/// Turns a run of indices into triangles and appends them, keeping the winding (thesis
/// figure 4.18). A quad a b c d becomes a b c, a c d; every other triangle of a strip is turned
/// round. Errors: IncompletePrimitive (nothing is appended), InvalidPrimitive. An empty run is no
/// error.
AoStatus flatten(AoPrimitive primitive, std::span<const std::uint32_t> run,
                 std::vector<std::uint32_t>& triangles);

} // namespace aolib
