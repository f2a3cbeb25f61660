#include "backbone/texels/LayerCapture.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

#include <glm/matrix.hpp>

#include "gl/Label.h"

namespace aolib {

namespace {

using Format = gl::RenderToTexture2D::Format;
using Depth = gl::RenderToTexture2D::Depth;

/// An open mesh shows one side when the other fills at most this share of its texels: cracks let a
/// back through here and there.
constexpr double kShareOfCracks = 0.02;
constexpr int kViewUnit = 3; ///< texture unit of the view's layers

AoStatus notShown() {
    return {StatusCode::OutOfMemory, "aolib/peel: mapping the readback buffer failed"};
}

} // namespace

std::size_t LayerCapture::Targets::bytes() const {
    std::size_t sum = entries[0].bytes() + entries[1].bytes() + exits.bytes() + counts.bytes();
    for (const gl::PixelReadback& readback : readbacks) {
        sum += readback.bytes();
    }
    return sum;
}

WorkUnit LayerCapture::next() const {
    switch (stage_) {
    case Stage::Sides:
    case Stage::Count:
        return WorkUnit::Draw;
    case Stage::ReadSides:
    case Stage::ReadCounts:
        return WorkUnit::Read;
    case Stage::Peel:
        return WorkUnit::Peel;
    default:
        return WorkUnit::Prepare;
    }
}

bool LayerCapture::waits() const {
    if (stage_ != Stage::ReadSides && stage_ != Stage::ReadCounts) {
        return false;
    }
    const Targets& targets = (*targets_)[sizeOf(face_)];
    const gl::PixelReadback& readback = targets.readbacks[face_ < kFaces ? at() : 0];
    return readback.pending() && !readback.arrived();
}

LayerCapture::LayerCapture(const BackboneContext& context, const FaceCapture& faces,
                           std::vector<float> around, LayerPeeling& peeling, int most)
    : context_(context), faces_(faces), peeling_(peeling), most_(most) {
    around.resize(std::min(around.size(), LayerPeeling::kMostEnclosing));
    marks_.around = std::move(around);
}

AoStatus LayerCapture::step() {
    const gl::DebugGroup group(context_.gl, "aolib: peel layers");
    AoStatus status;
    switch (stage_) {
    case Stage::Targets:
        status = makeTargets();
        stage_ = Stage::Sides;
        break;
    case Stage::Sides:
        drawSides();
        break;
    case Stage::ReadSides:
        status = readSides();
        break;
    case Stage::Count:
        drawCount();
        break;
    case Stage::ReadCounts:
        status = readCount();
        break;
    case Stage::Layers:
        status = makeLayers();
        stage_ = Stage::Peel;
        break;
    case Stage::Peel:
        peel();
        break;
    case Stage::Complete:
        break;
    }
    mostBytes_ = std::max(mostBytes_, bytes());
    if (stage_ == Stage::Complete) {
        targets_.reset();
    }
    return status;
}

void LayerCapture::nextFace() {
    if (++face_ == faces_.faces()) {
        face_ = 0;
        stage_ = static_cast<Stage>(static_cast<int>(stage_) + 1);
    }
}

AoStatus LayerCapture::makeTargets() {
    targets_.emplace();
    AoStatus status = makeTargets((*targets_)[0], glm::ivec2(faces_.size()), kFaces);
    if (status && faces_.view()) {
        status = makeTargets((*targets_)[1], faces_.view()->size, 1);
    }
    return status;
}

AoStatus LayerCapture::makeTargets(Targets& made, const glm::ivec2& size, std::size_t faces) const {
    AoStatus status;
    const auto make = [&](gl::RenderToTexture2D& target, Format format, Depth depth,
                          const char* label) {
        if (!status) {
            return;
        }
        auto created = gl::RenderToTexture2D::create(context_.gl, {.width = size.x,
                                                                   .height = size.y,
                                                                   .targets = {format},
                                                                   .depth = depth,
                                                                   .label = label});
        status = created.status();
        if (created) {
            target = std::move(*created);
        }
    };
    make(made.entries[0], Format::RGBA32F, Depth::Depth32F, "aolib/peel/entry0");
    make(made.entries[1], Format::RGBA32F, Depth::Depth32F, "aolib/peel/entry1");
    make(made.exits, Format::R32F, Depth::Depth32F, "aolib/peel/exit");
    make(made.counts, Format::R8, Depth::None, "aolib/peel/count");
    const auto texels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
    while (status && made.readbacks.size() < faces) {
        auto created =
            gl::PixelReadback::create(context_.gl, texels * sizeof(float), "aolib/peel/readback");
        status = created.status();
        if (created) {
            made.readbacks.push_back(std::move(*created));
        }
    }
    return status;
}

// ---- Which faces hold geometry, and the open meshes that do not only show fronts
// -----------------

void LayerCapture::drawSides() {
    const gl::RenderToTexture2D& sides = targets().exits;
    if (peeling_.drawSides(faces_, face_, sides)) {
        sides.bindForReading(0);
        readback().start(sides.width(), sides.height(), GL_RED, GL_FLOAT);
    }
    nextFace();
}

AoStatus LayerCapture::readSides() {
    if (readback().pending() && !readback().finish([&](std::span<const std::uint8_t> bytes) {
            std::vector<float> texels(bytes.size() / sizeof(float));
            std::memcpy(texels.data(), bytes.data(), bytes.size());
            for (const float texel : texels) {
                const int side = static_cast<int>(texel);
                counts_[at()] = std::max(counts_[at()], side >= 0 ? 1 : 0);
                if (side > 0) {
                    Sides& sides = seen_[side / 2];
                    ++(side % 2 != 0 ? sides.front : sides.back);
                }
            }
        })) {
        return notShown();
    }
    nextFace();
    if (stage_ != Stage::ReadSides) {
        marks_.unusual = unusualOpenMeshes();
    }
    return {};
}

std::vector<float> LayerCapture::unusualOpenMeshes() const {
    std::vector<std::pair<std::size_t, float>> found;
    for (const auto& [openMesh, sides] : seen_) {
        const std::size_t texels = sides.front + sides.back;
        const double cracks = kShareOfCracks * static_cast<double>(texels);
        if (static_cast<double>(sides.back) > cracks) {
            const bool onlyBacks = static_cast<double>(sides.front) <= cracks;
            found.emplace_back(texels, static_cast<float>(onlyBacks ? -openMesh : openMesh));
        }
    }
    std::sort(found.rbegin(), found.rend()); // those seen most first
    std::vector<float> openMeshes;
    for (const auto& entry : found) {
        openMeshes.push_back(entry.second);
    }
    openMeshes.resize(std::min(openMeshes.size(), LayerPeeling::kMostUnusual));
    return openMeshes;
}

// ---- How many layers there are ------------------------------------------------------------------

void LayerCapture::drawCount() {
    if (counts_[at()] > 0) {
        const gl::RenderToTexture2D& counts = targets().counts;
        peeling_.drawCounts(faces_, face_, marks_, counts);
        counts.bindForReading(0);
        readback().start(counts.width(), counts.height(), GL_RED, GL_UNSIGNED_BYTE);
    }
    nextFace();
}

AoStatus LayerCapture::readCount() {
    if (readback().pending() && !readback().finish([&](std::span<const std::uint8_t> bytes) {
            const auto texels = bytes.first(bytes.size() / sizeof(float));
            const int deepest = *std::max_element(texels.begin(), texels.end());
            counts_[at()] = std::clamp(deepest, 1, most_);
        })) {
        return notShown();
    }
    nextFace();
    return {};
}

AoStatus LayerCapture::makeLayers() {
    const std::array<int, 2> wanted{firstLayer(kFaces), counts_.back()};
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const glm::ivec2 size =
            i == 0 || !faces_.view() ? glm::ivec2(faces_.size()) : faces_.view()->size;
        if (i > 0 && wanted[i] == 0) {
            break;
        }
        auto made = gl::TextureStack::create(context_.gl, {.width = size.x,
                                                           .height = size.y,
                                                           .layers = std::max(wanted[i], 1),
                                                           .format = Format::RGBA32F,
                                                           .label = "aolib/layers"});
        if (!made) {
            return made.status();
        }
        intervals_[i] = std::move(*made);
    }
    return {};
}

// ---- Layers -------------------------------------------------------------------------------------

void LayerCapture::peel() {
    if (counts_[at()] == 0) {
        nextFace();
        return;
    }
    const auto& entries = targets().entries[static_cast<std::size_t>(layer_ % 2)];
    const auto& previous = targets().entries[static_cast<std::size_t>(1 - layer_ % 2)];
    const auto& exits = targets().exits;
    if (!entered_) {
        peeling_.peelEntries(faces_, face_, marks_, layer_ > 0 ? &previous : nullptr, exits,
                             entries);
        entered_ = true;
        return;
    }
    peeling_.peelExits(faces_, face_, marks_, entries, exits);
    intervals_[sizeOf(face_)].bindAsTarget((face_ < kFaces ? firstLayer(face_) : 0) + layer_);
    peeling_.pack(context_, entries, exits);
    entered_ = false;
    if (++layer_ == counts_[at()]) {
        layer_ = 0;
        nextFace();
    }
}

int LayerCapture::firstLayer(int face) const {
    return std::accumulate(counts_.begin(), counts_.begin() + face, 0);
}

int LayerCapture::layers() const {
    return *std::max_element(counts_.begin(), counts_.end());
}

void LayerCapture::bind(gl::GLSLShader& shader) const {
    std::array<glm::ivec4, kFaces> faceLayers{};
    for (int face = 0; face < kFaces; ++face) {
        const auto i = static_cast<std::size_t>(face);
        faceLayers[i] = {firstLayer(face), counts_[i], 0, 0};
    }
    intervals_[0].bind(0);
    shader.set("uIntervals", 0);
    if (const std::optional<ViewFace>& view = faces_.view()) {
        // Samplers must not lack a texture even where no layer is read.
        intervals_[counts_.back() > 0 ? 1 : 0].bind(kViewUnit);
        shader.set("uViewIntervals", kViewUnit);
        shader.set("uViewLayers", counts_.back());
        shader.set("uFrustum", view->frustum);
        shader.set("uFrustumRays", glm::inverse(view->frustum));
    }
    shader.set("uFaceLayers", faceLayers);
    shader.set("uLayers", layers());
    shader.set("uFaceSize", faces_.size());
}

std::array<bool, kFaces> LayerCapture::modelled() const {
    std::array<bool, kFaces> modelled{};
    std::transform(counts_.begin(), counts_.begin() + kFaces, modelled.begin(),
                   [](int count) { return count > 0; });
    return modelled;
}

std::size_t LayerCapture::bytes() const {
    return intervals_[0].bytes() + intervals_[1].bytes() +
           (targets_ ? (*targets_)[0].bytes() + (*targets_)[1].bytes() : 0);
}

} // namespace aolib
