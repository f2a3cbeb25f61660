#include "backbone/cubemapped/DetailStore.h"

#include <optional>

namespace aolib {

namespace {

using Format = gl::RenderToTexture2D::Format;

} // namespace

Status DetailStore::grow() {
    const int layers = slots_.count() / kPerLayer + 1;
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
    if (!slots_.empty()) {
        visibility->copyFrom(visibility_);
        depth->copyFrom(depth_);
    }
    visibility_ = std::move(*visibility);
    depth_ = std::move(*depth);
    slots_.growTo(layers * kPerLayer);
    return {};
}

Result<int> DetailStore::take() {
    std::optional<int> taken = slots_.take();
    if (!taken) {
        if (Status status = grow(); !status) {
            return status;
        }
        taken = slots_.take();
    }
    return *taken;
}

void DetailStore::giveBack(int block) {
    if (slots_.giveBack(block)) {
        visibility_ = {};
        depth_ = {};
        slots_.clear();
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
    if (!slots_.empty()) {
        visibility_.bind(visibilityUnit);
        depth_.bind(depthUnit);
    }
}

std::size_t DetailStore::bytes() const {
    return slots_.empty() ? 0 : visibility_.bytes() + depth_.bytes();
}

} // namespace aolib
