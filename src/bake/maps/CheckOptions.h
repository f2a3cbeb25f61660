#pragma once

#include <aolib/Status.h>
#include <aolib/bake/BakeOptions.h>

namespace aolib::bake {

// InvalidOption with the option's name, its value and its range, where one lies outside.
AoStatus check(const RayOptions& options);
AoStatus check(const ScatterOptions& options);
AoStatus check(const ShadowOptions& options);
AoStatus check(const MapOptions& options);
AoStatus check(const VertexOptions& options);

} // namespace aolib::bake
