#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <aolib/Options.h>
#include <aolib/Statistics.h>
#include <glm/vec2.hpp>

#include "app/View.h"
#include "content/Case.h"

namespace aolib::viewer {

/// The view as a case: what "aolib render --case" and every other tool draws again.
/// @param folder  where the case file goes; a model's file is named relative to it.
Case caseOf(const app::View& scene, const NamedCamera& camera, const glm::ivec2& pixels,
            const Options& options, const std::filesystem::path& folder);

/// The command that draws the case as the window shows it: with the options that a case does not
/// hold, and the cube maps where they stand.
std::string renderCommand(const std::string& caseFile, const Options& options,
                          const std::vector<CubeMapInfo>& cubeMaps);

} // namespace aolib::viewer
