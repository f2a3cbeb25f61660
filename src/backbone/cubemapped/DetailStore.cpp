#include "backbone/cubemapped/DetailStore.h"

#include <optional>

namespace aolib {

Result<int> DetailStore::take() {
    std::optional<int> taken = slots_.take();
    if (!taken) {
        const auto layer = faces_->take();
        if (!layer) {
            return layer.status();
        }
        layers_.push_back(*layer);
        slots_.growTo(slots_.count() + perLayer());
        taken = slots_.take();
    }
    return *taken;
}

void DetailStore::giveBack(int block) {
    if (slots_.giveBack(block)) {
        for (const int layer : layers_) {
            faces_->giveBack(layer);
        }
        layers_.clear();
        slots_.clear();
    }
}

FaceStore::Page DetailStore::page(int block) const {
    const int inLayer = block % perLayer();
    return {layers_[static_cast<std::size_t>(block / perLayer())],
            {inLayer % perRow(), inLayer / perRow()}};
}

void DetailStore::upload(int block, int width, int height, std::span<const std::uint8_t> visibility,
                         std::span<const std::uint16_t> depth) const {
    const FaceStore::Page where = page(block);
    faces_->upload(where.layer, kBlock * where.at, {width, height}, visibility, depth);
}

} // namespace aolib
