#pragma once

#include <string>

#include "app/BakeFlags.h"
#include "app/Failure.h"
#include "app/Progress.h"

namespace aolib::app {

/// Bakes one model and writes what was asked for, all of it or nothing.
/// @param out  the .glb to write; empty for none.
/// @return what was done, lines for people. Errors: BadInput, Failed (cancelled, disk, memory).
Result<std::string, Failure> bakeModel(const std::string& input, const std::string& out,
                                       const BakeFlags& flags, Progress& progress);

} // namespace aolib::app
