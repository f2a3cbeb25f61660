#include "backbone/cubemaps/FaceStore.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "gl/StateGuard.h"

namespace aolib {

namespace {

using Format = gl::RenderToTexture2D::Format;

/// Layers that are added at a time: a cube map's worth, since each growth copies what is there.
constexpr int kGrowth = 6;

} // namespace

void FaceStore::reset(int faceSize) {
    visibility_ = {};
    depth_ = {};
    pageTable_ = {};
    layers_.clear();
    faceSize_ = faceSize;
    unreserved_ = 0;
}

bool FaceStore::reserve() {
    const bool room = freeLayers() >= kFaces;
    reserved_ += room ? kFaces : 0;
    return room;
}

AoStatus FaceStore::grow() {
    const int layers = std::min(layers_.count() + kGrowth, limit_);
    if (layers <= layers_.count()) {
        return {StatusCode::OutOfMemory, "aolib/faces: all " + std::to_string(limit_) +
                                             " layers that there is room for are taken"};
    }
    const auto create = [&](Format format, int size, const char* label) {
        return gl::TextureStack::create(
            *gl_,
            {.width = size, .height = size, .layers = layers, .format = format, .label = label});
    };
    if (!framebuffer_) {
        auto made = gl::Container::create(*gl_, gl::Container::kFramebuffer, "aolib/faces");
        if (!made) {
            return made.status();
        }
        framebuffer_ = std::move(*made);
    }
    auto visibility = create(Format::R8, faceSize_, "aolib/faces/visibility");
    if (!visibility) {
        return visibility.status();
    }
    auto depth = create(Format::R16, faceSize_, "aolib/faces/depth");
    if (!depth) {
        return depth.status();
    }
    auto pages = create(Format::RG16, tilesPerEdge(faceSize_), "aolib/faces/pages");
    if (!pages) {
        return pages.status();
    }
    if (!layers_.empty()) {
        visibility->copyFrom(visibility_);
        depth->copyFrom(depth_);
        pages->copyFrom(pageTable_);
    }
    pageTable_ = std::move(*pages);
    visibility_ = std::move(*visibility);
    depth_ = std::move(*depth);
    layers_.growTo(layers);
    return {};
}

Result<int> FaceStore::allocate() {
    if (freeLayers() < 1) {
        return AoStatus(StatusCode::OutOfMemory,
                        "aolib/faces: all " + std::to_string(limit_) +
                            " layers that there is room for are taken or set aside");
    }
    const auto layer = allocateReserved();
    unreserved_ += layer ? 1 : 0;
    return layer;
}

void FaceStore::release(int layer) {
    --unreserved_;
    releaseReserved(layer);
}

Result<int> FaceStore::allocateReserved() {
    std::optional<int> allocated = layers_.allocate();
    if (!allocated) {
        if (AoStatus status = grow(); !status) {
            return status;
        }
        allocated = layers_.allocate();
    }
    const int layer = *allocated;
    const std::array<GLfloat, 4> open{1.0F, 0.0F, 0.0F, 0.0F};
    const std::array<GLfloat, 4> nothing{};
    bindAsTarget(layer);
    gl_->ClearBufferfv(GL_COLOR, 0, open.data());
    gl_->ClearBufferfv(GL_COLOR, 1, nothing.data());
    const int tiles = tilesPerEdge(faceSize_);
    const std::vector<std::uint16_t> none(2 * static_cast<std::size_t>(tiles * tiles));
    pageTable_.upload(layer, {0, 0}, {tiles, tiles}, none.data());
    return layer;
}

void FaceStore::releaseReserved(int layer) {
    if (layers_.release(layer)) {
        reset(faceSize_);
    }
}

void FaceStore::bindAsTarget(int layer) const {
    constexpr std::array<GLenum, 2> kBoth{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    gl::useTargets(*gl_, static_cast<int>(kBoth.size()));
    gl_->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
    visibility_.attach(0, layer);
    depth_.attach(1, layer);
    gl_->DrawBuffers(static_cast<GLsizei>(kBoth.size()), kBoth.data());
    gl::setViewport(*gl_, 0, 0, faceSize_, faceSize_);
}

void FaceStore::bindForReading(int layer, int which) const {
    bindAsTarget(layer);
    gl_->ReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(which));
}

void FaceStore::upload(int layer, const glm::ivec2& at, const glm::ivec2& size,
                       std::span<const std::uint8_t> visibility,
                       std::span<const std::uint16_t> depth) const {
    visibility_.upload(layer, at, size, visibility.data());
    depth_.upload(layer, at, size, depth.data());
}

void FaceStore::setPage(int layer, const glm::ivec2& tile,
                        const std::optional<PageLocation>& page) const {
    std::array<std::uint16_t, 2> code{};
    if (page) {
        code = {static_cast<std::uint16_t>(page->layer + 1),
                static_cast<std::uint16_t>(page->place.x | page->place.y << 8)};
    }
    pageTable_.upload(layer, tile, {1, 1}, code.data());
}

void FaceStore::bindPages(gl::GLSLShader& shader, int unit) const {
    pageTable_.bind(unit);
    shader.set("uPages", unit);
}

void FaceStore::bind(gl::GLSLShader& shader, int visibilityUnit, int depthUnit) const {
    visibility_.bind(visibilityUnit);
    depth_.bind(depthUnit);
    shader.set("uCubeVisibility", visibilityUnit);
    shader.set("uCubeDepth", depthUnit);
    shader.set("uFaceSize", faceSize_);
}

std::size_t FaceStore::bytes() const {
    return layers_.empty() ? 0 : visibility_.bytes() + depth_.bytes() + pageTable_.bytes();
}

} // namespace aolib
