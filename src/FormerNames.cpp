#include "FormerNames.h"

// The one place that uses deprecated names.
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
#elif defined(_MSC_VER)
#pragma warning(disable : 4996)
#endif

namespace aolib {

void applyFormerNames(CubeMapOptions& options) {
    options.refineStaticViews = options.refineStaticViews && options.repair;
    options.screenSpaceFallback = options.screenSpaceFallback && options.fallback;
}

void setFormerNames(Statistics& statistics) {
    statistics.pixelsRepaired = statistics.pixelsRefined;
}

} // namespace aolib
