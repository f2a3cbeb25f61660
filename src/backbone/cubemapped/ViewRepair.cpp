#include "backbone/cubemapped/ViewRepair.h"

namespace aolib {

void ViewRepair::follow(const Frame& frame, PixelSources::Kind kind, const Make& make) {
    const Sight sight{frame.camera, frame.size, frame.clip};
    if (sight_ == sight && kind_ == kind) {
        ++framesAtRest_;
        return;
    }
    restart();
    if (kind_ != kind) {
        source_ = kind == PixelSources::Kind::None ? nullptr : make();
        kind_ = kind;
    }
    sight_ = sight;
    framesAtRest_ = 0;
}

void ViewRepair::dropSource() {
    restart();
    source_.reset();
    kind_ = PixelSources::Kind::None;
}

void ViewRepair::restart() {
    found_.drop();
    if (source_ != nullptr) {
        source_->restart();
    }
}

void ViewRepair::lookAgain() {
    if (source_ != nullptr) {
        source_->lookAgain();
    }
}

} // namespace aolib
