#include "backbone/cubemaps/PageStore.h"

#include <optional>

namespace aolib {

Result<int> PageStore::allocate() {
    std::optional<int> page = pages_.allocate();
    if (!page) {
        const auto layer = faces_->allocate();
        if (!layer) {
            return layer.status();
        }
        layers_.push_back(*layer);
        pages_.growTo(pages_.count() + perLayer());
        page = pages_.allocate();
    }
    return *page;
}

void PageStore::release(int page) {
    if (pages_.release(page)) {
        for (const int layer : layers_) {
            faces_->release(layer);
        }
        layers_.clear();
        pages_.clear();
    }
}

FaceStore::PageLocation PageStore::location(int page) const {
    const int inLayer = page % perLayer();
    return {layers_[static_cast<std::size_t>(page / perLayer())],
            {inLayer % perRow(), inLayer / perRow()}};
}

void PageStore::upload(int page, int width, int height, std::span<const std::uint8_t> visibility,
                       std::span<const std::uint16_t> depth) const {
    const FaceStore::PageLocation at = location(page);
    faces_->upload(at.layer, edge() * at.place, {width, height}, visibility, depth);
}

glm::ivec2 PageStore::bindAsTarget(int page) const {
    const FaceStore::PageLocation at = location(page);
    faces_->bindAsTarget(at.layer);
    return edge() * at.place;
}

} // namespace aolib
