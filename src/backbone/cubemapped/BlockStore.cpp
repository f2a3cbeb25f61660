#include "backbone/cubemapped/BlockStore.h"

#include <optional>

namespace aolib {

Result<int> BlockStore::take() {
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

void BlockStore::giveBack(int block) {
    if (slots_.giveBack(block)) {
        for (const int layer : layers_) {
            faces_->giveBack(layer);
        }
        layers_.clear();
        slots_.clear();
    }
}

FaceStore::Page BlockStore::page(int block) const {
    const int inLayer = block % perLayer();
    return {layers_[static_cast<std::size_t>(block / perLayer())],
            {inLayer % perRow(), inLayer / perRow()}};
}

void BlockStore::upload(int block, int width, int height, std::span<const std::uint8_t> visibility,
                        std::span<const std::uint16_t> depth) const {
    const FaceStore::Page where = page(block);
    faces_->upload(where.layer, edge() * where.at, {width, height}, visibility, depth);
}

glm::ivec2 BlockStore::begin(int block) const {
    const FaceStore::Page where = page(block);
    faces_->begin(where.layer);
    return edge() * where.at;
}

} // namespace aolib
