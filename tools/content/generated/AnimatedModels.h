#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "content/LoadError.h"

namespace aolib {

/// Models that move, by name: "arm" (a skin that bends by 140 degrees), "hinge" (two nodes that
/// close like a book), "bellows" (a morph target that folds it). Each has one animation of 2 s.
std::vector<std::string> animatedModelNames();

/// The model of a name as a GLB; fails where there is none.
Result<std::string, LoadError> animatedModel(std::string_view name);

} // namespace aolib
