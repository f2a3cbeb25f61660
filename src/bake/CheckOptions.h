#pragma once

#include <aolib/Status.h>
#include <aolib/bake/BakeOptions.h>

namespace aolib::bake {

// InvalidOption with the option's name, its value and its range, where one lies outside.
Status check(const RayOptions& options);
Status check(const ScatterOptions& options);
Status check(const ShadowOptions& options);
Status check(const MapOptions& options);
Status check(const VertexOptions& options);

} // namespace aolib::bake
