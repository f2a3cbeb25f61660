#pragma once

#include <filesystem>
#include <string_view>

#include <aolib/lighting/EnvironmentMap.h>

#include "content/LoadError.h"

namespace aolib {

/// An environment from the bytes of a Radiance file (.hdr, .pic; RGBE). `file` names it in
/// messages. Fails with a sentence on what is none, is cut off, or is beyond 16384 texels a side.
Result<lighting::EnvironmentMap, LoadError> readHdr(std::string_view bytes,
                                                    const std::filesystem::path& file);

} // namespace aolib
