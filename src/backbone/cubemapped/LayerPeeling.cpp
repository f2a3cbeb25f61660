#include "backbone/cubemapped/LayerPeeling.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "backbone/ShaderLibrary.h"
#include "gl/Label.h"

namespace aolib {

namespace {

using Format = gl::RenderToTexture2D::Format;
using Depth = gl::RenderToTexture2D::Depth;

/// Solids that may contain a cube's centre, as shaders/cubemap/peel.glsl has room for.
constexpr std::size_t kMostAround = 16;

constexpr std::array<GLfloat, 4> kNothing{-1.0F, -1.0F, 0.0F, 0.0F};

Result<gl::RenderToTexture2D> target(const gl::Functions& gl, int faceSize, Format format,
                                     Depth depth, const char* label) {
    return gl::RenderToTexture2D::create(gl, {.width = kFaces * faceSize,
                                              .height = faceSize,
                                              .targets = {format},
                                              .depth = depth,
                                              .label = label});
}

void clear(const gl::Functions& gl, const gl::RenderToTexture2D& target, bool depth) {
    const GLfloat deepest = 1.0F;
    target.beginAll();
    gl.ClearBufferfv(GL_COLOR, 0, kNothing.data());
    if (depth) {
        gl.ClearBufferfv(GL_DEPTH, 0, &deepest);
    }
}

void setAround(gl::GLSLShader& shader, const std::vector<float>& around) {
    shader.set("uInside", around);
    shader.set("uInsideCount", static_cast<int>(around.size()));
}

} // namespace

struct LayerPeeling::Targets {
    std::array<gl::RenderToTexture2D, 2> entries; ///< distance, solid, octahedral normal
    gl::RenderToTexture2D exits;
    std::vector<float> around; ///< solids that contain the cube's centre
};

Result<LayerPeeling> LayerPeeling::create(const BackboneContext& context) {
    LayerPeeling peeling;
    Status status;
    const auto build = [&](gl::GLSLShader& shader, const char* vertex, const char* fragment) {
        if (!status) {
            return;
        }
        auto built = buildShader(context.gl, vertex, fragment);
        status = built.status();
        if (built) {
            shader = std::move(*built);
        }
    };
    build(peeling.count_, "cubemap/peel.vert", "cubemap/count_layers.frag");
    build(peeling.entry_, "cubemap/peel.vert", "cubemap/peel_entry.frag");
    build(peeling.exit_, "cubemap/peel.vert", "cubemap/peel_exit.frag");
    build(peeling.pack_, "fullscreen.vert", "cubemap/pack_interval.frag");
    if (!status) {
        return status;
    }
    return peeling;
}

Result<int> LayerPeeling::countLayers(const FaceCapture& faces, const Targets& targets,
                                      int faceSize, int most, std::array<bool, kFaces>& modelled,
                                      const gl::Functions& gl) {
    const auto counts = target(gl, faceSize, Format::R8, Depth::None, "aolib/peel/count");
    if (!counts) {
        return counts.status();
    }
    const std::array<GLfloat, 4> zero{};
    counts->begin(0);
    gl.ClearBufferfv(GL_COLOR, 0, zero.data());
    gl.Enable(GL_BLEND);
    gl.BlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    count_.bind();
    setAround(count_, targets.around);
    faces.draw(count_);
    gl.Disable(GL_BLEND);
    std::vector<std::uint8_t> texels(static_cast<std::size_t>(kFaces * faceSize * faceSize));
    counts->beginRead(0);
    gl.ReadPixels(0, 0, kFaces * faceSize, faceSize, GL_RED, GL_UNSIGNED_BYTE, texels.data());
    int deepest = 0;
    for (std::size_t i = 0; i < texels.size(); ++i) {
        deepest = std::max(deepest, static_cast<int>(texels[i]));
        const std::size_t face = i / static_cast<std::size_t>(faceSize) % kFaces;
        modelled[face] = modelled[face] || texels[i] != 0;
    }
    return std::clamp(deepest, 1, most);
}

void LayerPeeling::peelEntries(const FaceCapture& faces, const Targets& targets,
                               const gl::RenderToTexture2D* previous,
                               const gl::RenderToTexture2D& entry, const gl::Functions& gl) {
    clear(gl, entry, true);
    entry_.bind();
    if (previous != nullptr) {
        previous->bindTexture(0, 0);
    }
    entry_.set("uPrevious", 0);
    entry_.set("uFirstLayer", previous == nullptr ? 1 : 0);
    setAround(entry_, targets.around);
    faces.draw(entry_);
}

void LayerPeeling::peelExits(const FaceCapture& faces, const Targets& targets,
                             const gl::RenderToTexture2D& entry, const gl::Functions& gl) {
    clear(gl, targets.exits, true);
    exit_.bind();
    entry.bindTexture(0, 0);
    exit_.set("uEntry", 0);
    setAround(exit_, targets.around);
    faces.draw(exit_);
}

Result<LayerPeeling::Layers> LayerPeeling::capture(const BackboneContext& context,
                                                   const SceneGeometry& geometry,
                                                   const CubeMapProjector& projector,
                                                   const DistanceRange& range, int most) {
    const gl::DebugGroup group(context.gl, "aolib: peel layers");
    const gl::Functions& gl = context.gl;
    const int faceSize = projector.faceSize();
    Targets targets;
    Status status;
    const auto make = [&](gl::RenderToTexture2D& made, Format format, Depth depth,
                          const char* label) {
        if (!status) {
            return;
        }
        auto created = target(gl, faceSize, format, depth, label);
        status = created.status();
        if (created) {
            made = std::move(*created);
        }
    };
    make(targets.entries[0], Format::RGBA32F, Depth::Depth32F, "aolib/peel/entry0");
    make(targets.entries[1], Format::RGBA32F, Depth::Depth32F, "aolib/peel/entry1");
    make(targets.exits, Format::R32F, Depth::Depth32F, "aolib/peel/exit");
    if (!status) {
        return status;
    }
    targets.around = geometry.solidsAround(context.scene, projector.position());
    targets.around.resize(std::min(targets.around.size(), kMostAround));

    Layers layers;
    const FaceCapture faces(context, geometry, projector, range);
    gl::RenderToTexture2D* entry = &targets.entries[0];
    gl::RenderToTexture2D* next = &targets.entries[1];
    const auto count = countLayers(faces, targets, faceSize, most, layers.modelled, gl);
    if (!count) {
        return count.status();
    }
    auto intervals = gl::TextureStack::create(gl, {.width = kFaces * faceSize,
                                                   .height = faceSize,
                                                   .layers = *count,
                                                   .format = Format::RGBA32F,
                                                   .label = "aolib/layers"});
    if (!intervals) {
        return intervals.status();
    }
    layers.intervals = std::move(*intervals);
    peelEntries(faces, targets, nullptr, *entry, gl);
    for (int layer = 0; layer < *count; ++layer) {
        peelExits(faces, targets, *entry, gl);
        // One more than is kept: it tells which surface is the last along its ray.
        peelEntries(faces, targets, entry, *next, gl);
        layers.intervals.begin(layer);
        pack_.bind();
        entry->bindTexture(0, 0);
        targets.exits.bindTexture(0, 1);
        next->bindTexture(0, 2);
        pack_.set("uEntry", 0);
        pack_.set("uExit", 1);
        pack_.set("uNext", 2);
        context.generated.drawFullscreen();
        std::swap(entry, next);
    }
    layers.bytes =
        targets.entries[0].bytes() * 2 + targets.exits.bytes() + layers.intervals.bytes();
    return layers;
}

void LayerPeeling::bind(gl::GLSLShader& shader, const Layers& layers, int faceSize) {
    layers.intervals.bind(0);
    shader.set("uIntervals", 0);
    shader.set("uLayers", layers.intervals.layers());
    shader.set("uFaceSize", faceSize);
}

} // namespace aolib
