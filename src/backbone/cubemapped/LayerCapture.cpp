#include "backbone/cubemapped/LayerCapture.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <utility>

#include "gl/Label.h"

namespace aolib {

namespace {

using Format = gl::RenderToTexture2D::Format;
using Depth = gl::RenderToTexture2D::Depth;

/// A sheet shows one side when the other fills at most this share of its texels: cracks let a back
/// through here and there.
constexpr double kShareOfCracks = 0.02;

Status notShown() {
    return {StatusCode::OutOfMemory, "aolib/peel: GL does not show what was read back"};
}

} // namespace

std::size_t LayerCapture::Targets::bytes() const {
    return entries[0].bytes() + entries[1].bytes() + exits.bytes() + counts.bytes() +
           kFaces * readbacks[0].bytes();
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
    const gl::PixelReadback& readback = targets_->readbacks[at()];
    return readback.pending() && !readback.arrived();
}

Status LayerCapture::step() {
    const gl::DebugGroup group(context_.gl, "aolib: peel layers");
    Status status;
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
    if (++face_ == kFaces) {
        face_ = 0;
        stage_ = static_cast<Stage>(static_cast<int>(stage_) + 1);
    }
}

Status LayerCapture::makeTargets() {
    Targets& made = targets_.emplace();
    Status status;
    const auto make = [&](gl::RenderToTexture2D& target, Format format, Depth depth,
                          const char* label) {
        if (!status) {
            return;
        }
        auto created = gl::RenderToTexture2D::create(context_.gl, {.width = faces_.size(),
                                                                   .height = faces_.size(),
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
    const auto texels = static_cast<std::size_t>(faces_.size() * faces_.size());
    for (gl::PixelReadback& readback : made.readbacks) {
        if (status) {
            auto created = gl::PixelReadback::create(context_.gl, texels * sizeof(float),
                                                     "aolib/peel/readback");
            status = created.status();
            if (created) {
                readback = std::move(*created);
            }
        }
    }
    marks_.around = geometry_.solidsAround(context_.scene, faces_.centre());
    marks_.around.resize(std::min(marks_.around.size(), LayerPeeling::kMostAround));
    return status;
}

// ---- Which faces hold geometry, and the sheets of which not only the fronts show ----------------

void LayerCapture::drawSides() {
    if (peeling_.drawSides(faces_, face_, targets_->exits)) {
        targets_->exits.beginRead(0);
        targets_->readbacks[at()].start(faces_.size(), faces_.size(), GL_RED, GL_FLOAT);
    }
    nextFace();
}

Status LayerCapture::readSides() {
    gl::PixelReadback& readback = targets_->readbacks[at()];
    if (readback.pending() && !readback.finish([&](std::span<const std::uint8_t> bytes) {
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
        marks_.unusual = unusualSheets();
    }
    return {};
}

std::vector<float> LayerCapture::unusualSheets() const {
    std::vector<std::pair<std::size_t, float>> found;
    for (const auto& [sheet, sides] : seen_) {
        const std::size_t texels = sides.front + sides.back;
        const double cracks = kShareOfCracks * static_cast<double>(texels);
        if (static_cast<double>(sides.back) > cracks) {
            const bool onlyBacks = static_cast<double>(sides.front) <= cracks;
            found.emplace_back(texels, static_cast<float>(onlyBacks ? -sheet : sheet));
        }
    }
    std::sort(found.rbegin(), found.rend()); // those seen most first
    std::vector<float> sheets;
    for (const auto& entry : found) {
        sheets.push_back(entry.second);
    }
    sheets.resize(std::min(sheets.size(), LayerPeeling::kMostUnusual));
    return sheets;
}

// ---- How many layers there are ------------------------------------------------------------------

void LayerCapture::drawCount() {
    if (counts_[at()] > 0) {
        peeling_.drawCounts(faces_, face_, marks_, targets_->counts);
        targets_->counts.beginRead(0);
        targets_->readbacks[at()].start(faces_.size(), faces_.size(), GL_RED, GL_UNSIGNED_BYTE);
    }
    nextFace();
}

Status LayerCapture::readCount() {
    gl::PixelReadback& readback = targets_->readbacks[at()];
    if (readback.pending() && !readback.finish([&](std::span<const std::uint8_t> bytes) {
            const auto texels = bytes.first(bytes.size() / sizeof(float));
            const int deepest = *std::max_element(texels.begin(), texels.end());
            counts_[at()] = std::clamp(deepest, 1, most_);
        })) {
        return notShown();
    }
    nextFace();
    return {};
}

Status LayerCapture::makeLayers() {
    const int all = std::accumulate(counts_.begin(), counts_.end(), 0);
    auto made = gl::TextureStack::create(context_.gl, {.width = faces_.size(),
                                                       .height = faces_.size(),
                                                       .layers = std::max(all, 1),
                                                       .format = Format::RGBA32F,
                                                       .label = "aolib/layers"});
    if (made) {
        intervals_ = std::move(*made);
    }
    return made.status();
}

// ---- Layers -------------------------------------------------------------------------------------

void LayerCapture::peel() {
    if (counts_[at()] == 0) {
        nextFace();
        return;
    }
    const auto& entries = targets_->entries[static_cast<std::size_t>(layer_ % 2)];
    const auto& previous = targets_->entries[static_cast<std::size_t>(1 - layer_ % 2)];
    if (!entered_) {
        peeling_.peelEntries(faces_, face_, marks_, layer_ > 0 ? &previous : nullptr,
                             targets_->exits, entries);
        entered_ = true;
        return;
    }
    peeling_.peelExits(faces_, face_, marks_, entries, targets_->exits);
    intervals_.begin(firstLayer(face_) + layer_);
    peeling_.pack(context_, entries, targets_->exits);
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
    intervals_.bind(0);
    shader.set("uIntervals", 0);
    shader.set("uFaceLayers", faceLayers);
    shader.set("uLayers", layers());
    shader.set("uFaceSize", faces_.size());
}

std::array<bool, kFaces> LayerCapture::modelled() const {
    std::array<bool, kFaces> modelled{};
    std::transform(counts_.begin(), counts_.end(), modelled.begin(),
                   [](int count) { return count > 0; });
    return modelled;
}

std::size_t LayerCapture::bytes() const {
    return intervals_.bytes() + (targets_ ? targets_->bytes() : 0);
}

} // namespace aolib
