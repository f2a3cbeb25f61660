#include "backbone/cubemapped/DetailStore.h"

#include <algorithm>

namespace aolib {

namespace {

using Format = gl::RenderToTexture2D::Format;

} // namespace

Status DetailStore::grow() {
    const int layers = static_cast<int>(used_.size()) / kPerLayer + 1;
    const auto create = [&](Format format, const char* label) {
        return gl::TextureStack::create(*gl_, {.width = kPerRow * kBlock,
                                               .height = kPerRow * kBlock,
                                               .layers = layers,
                                               .format = format,
                                               .label = label});
    };
    auto visibility = create(Format::R8, "aolib/details/visibility");
    if (!visibility) {
        return visibility.status();
    }
    auto depth = create(Format::R16, "aolib/details/depth");
    if (!depth) {
        return depth.status();
    }
    if (!used_.empty()) {
        visibility->copyFrom(visibility_);
        depth->copyFrom(depth_);
    }
    visibility_ = std::move(*visibility);
    depth_ = std::move(*depth);
    used_.resize(static_cast<std::size_t>(layers * kPerLayer), false);
    return {};
}

Result<int> DetailStore::take() {
    auto free = std::find(used_.begin(), used_.end(), false);
    if (free == used_.end()) {
        const std::size_t before = used_.size();
        if (Status status = grow(); !status) {
            return status;
        }
        free = used_.begin() + static_cast<std::ptrdiff_t>(before);
    }
    *free = true;
    return static_cast<int>(free - used_.begin());
}

void DetailStore::giveBack(int block) {
    used_.at(static_cast<std::size_t>(block)) = false;
    if (std::none_of(used_.begin(), used_.end(), [](bool used) { return used; })) {
        visibility_ = {};
        depth_ = {};
        used_.clear();
    }
}

void DetailStore::upload(int block, int width, int height, std::span<const std::uint8_t> visibility,
                         std::span<const std::uint16_t> depth) const {
    const int layer = block / kPerLayer;
    const int inLayer = block % kPerLayer;
    const glm::ivec2 at = kBlock * glm::ivec2(inLayer % kPerRow, inLayer / kPerRow);
    visibility_.upload(layer, at, {width, height}, visibility.data());
    depth_.upload(layer, at, {width, height}, depth.data());
}

void DetailStore::bind(gl::GLSLShader& shader, int visibilityUnit, int depthUnit) const {
    shader.set("uDetailVisibility", visibilityUnit);
    shader.set("uDetailDepth", depthUnit);
    if (!used_.empty()) {
        visibility_.bind(visibilityUnit);
        depth_.bind(depthUnit);
    }
}

std::size_t DetailStore::bytes() const {
    return used_.empty() ? 0 : visibility_.bytes() + depth_.bytes();
}

} // namespace aolib
