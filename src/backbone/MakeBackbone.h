#pragma once

#include <memory>

#include "backbone/AbstractBackbone.h"

namespace aolib {

/// Makes the strategy that the options name. Errors: ShaderError, OutOfMemory.
Result<std::unique_ptr<AbstractBackbone>> makeBackbone(const BackboneContext& context);

} // namespace aolib
