#pragma once

#include <set>
#include <utility>

#include "HostGl.h"

namespace aolib {

/// The names of GL objects of each kind that are alive, by the host's own functions.
std::set<std::pair<char, GLuint>> aliveNames(const HostGl& gl);

} // namespace aolib
