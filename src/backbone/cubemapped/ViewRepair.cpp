#include "backbone/cubemapped/ViewRepair.h"

namespace aolib {

void ViewRepair::follow(const Frame& frame, AbstractPixelSource* source) {
    const View view{frame.camera, frame.size, frame.clip};
    if (view_ == view && source_ == source) {
        ++framesAtRest_;
        return;
    }
    restart();
    source_ = source;
    view_ = view;
    framesAtRest_ = 0;
}

void ViewRepair::dropSource() {
    restart();
    source_ = nullptr;
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
