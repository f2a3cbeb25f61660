#pragma once

#include <vector>

#include "content/Model.h"
#include "content/NamedCamera.h"

namespace aolib {

/// Two views of a loaded model. Models that are known by name and size have views chosen by hand,
/// for interiors from inside; for others one view frames the bounds from the front right and above,
/// and one from the front left and low down. Near and far planes enclose the whole model.
std::vector<NamedCamera> defaultCameras(const Model& model);

} // namespace aolib
