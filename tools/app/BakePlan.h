#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <aolib/bake/UvReport.h>

#include "app/BakeFlags.h"
#include "app/BakeInput.h"
#include "app/Failure.h"

namespace aolib::app {

/// A map: of all pieces that share a material.
struct PlannedMap {
    std::string name;
    int material = 0;
    std::vector<std::size_t> pieces;
    int uvSet = 0;
    bake::UvReport given;   ///< of the model's own UVs, the best set that there is
    std::size_t charts = 0; ///< above 0: UVs are our own
};

/// Decides which UVs each material's map takes, and gives the input's pieces those UVs and the
/// numbers of their maps. Where they are our own, vertices of the glTF are split and a UV set is
/// added. Errors: BadInput, with the numbers of what is wrong with the UVs.
Result<std::vector<PlannedMap>, Failure> planMaps(BakeInput& input, const BakeFlags& flags);

} // namespace aolib::app
