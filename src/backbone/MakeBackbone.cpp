#include "backbone/MakeBackbone.h"

#include "backbone/BackboneCubemapped.h"
#include "backbone/BackboneScreenSpace.h"

namespace aolib {

Result<std::unique_ptr<AbstractBackbone>> makeBackbone(const BackboneContext& context) {
    switch (context.options.backbone) {
    case Backbone::Cubemapped:
        return BackboneCubemapped::create(context);
    case Backbone::ScreenSpace:
        return BackboneScreenSpace::create(context);
    }
    return AoStatus(StatusCode::InvalidOption, "backbone: a value that names none");
}

} // namespace aolib
