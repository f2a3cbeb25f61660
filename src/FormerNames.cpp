#include "FormerNames.h"

namespace aolib {

void applyFormerNames(CubeMapOptions& options) {
    options.refineStaticViews = options.refineStaticViews && options.repair;
    options.screenSpaceFallback = options.screenSpaceFallback && options.fallback;
}

void setFormerNames(Statistics& statistics) {
    statistics.pixelsRepaired = statistics.pixelsRefined;
}

} // namespace aolib
