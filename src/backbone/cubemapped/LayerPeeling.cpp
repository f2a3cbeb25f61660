#include "backbone/cubemapped/LayerPeeling.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "backbone/ShaderLibrary.h"
#include "gl/Label.h"

namespace aolib {

namespace {

using Format = gl::RenderToTexture2D::Format;
using Depth = gl::RenderToTexture2D::Depth;

/// Solids that may contain a cube's centre, as shaders/cubemap/peel.glsl has room for.
constexpr std::size_t kMostAround = 16;

/// Sheets that are no lids, as shaders/cubemap/peel.vert has room for.
constexpr std::size_t kMostUnusual = 128;

/// A sheet shows one side when the other fills at most this share of its texels: cracks let a back
/// through here and there.
constexpr double kShareOfCracks = 0.02;

constexpr std::array<GLfloat, 4> kNothing{-1.0F, -1.0F, 0.0F, 0.0F};
constexpr std::array<GLfloat, 4> kNoExit{0.0F, 0.0F, 0.0F, 0.0F};

Result<gl::RenderToTexture2D> target(const gl::Functions& gl, int faceSize, Format format,
                                     Depth depth, const char* label) {
    return gl::RenderToTexture2D::create(gl, {.width = kFaces * faceSize,
                                              .height = faceSize,
                                              .targets = {format},
                                              .depth = depth,
                                              .label = label});
}

void clear(const gl::Functions& gl, const gl::RenderToTexture2D& target,
           const std::array<GLfloat, 4>& value) {
    const GLfloat deepest = 1.0F;
    target.beginAll();
    gl.ClearBufferfv(GL_COLOR, 0, value.data());
    gl.ClearBufferfv(GL_DEPTH, 0, &deepest);
}

/// How many texels show a sheet's front and its back.
struct Sides {
    std::size_t front = 0;
    std::size_t back = 0;
};

/// The sheets that are no lids, as uUnusual of shaders/cubemap/peel.vert, those seen most first.
std::vector<float> unusualSheets(const std::map<int, Sides>& seen) {
    std::vector<std::pair<std::size_t, float>> found;
    for (const auto& [sheet, sides] : seen) {
        const std::size_t texels = sides.front + sides.back;
        const double cracks = kShareOfCracks * static_cast<double>(texels);
        if (static_cast<double>(sides.back) > cracks) {
            const bool onlyBacks = static_cast<double>(sides.front) <= cracks;
            found.emplace_back(texels, static_cast<float>(onlyBacks ? -sheet : sheet));
        }
    }
    std::sort(found.rbegin(), found.rend());
    std::vector<float> sheets;
    for (const auto& entry : found) {
        sheets.push_back(entry.second);
    }
    sheets.resize(std::min(sheets.size(), kMostUnusual));
    return sheets;
}

} // namespace

struct LayerPeeling::Targets {
    std::array<gl::RenderToTexture2D, 2> entries; ///< distance, solid, octahedral normal
    gl::RenderToTexture2D exits;
    std::vector<float> around;  ///< solids that contain the cube's centre
    std::vector<float> unusual; ///< as unusualSheets()

    static Result<Targets> create(const gl::Functions& gl, int faceSize);
    void setUniforms(gl::GLSLShader& shader) const {
        shader.set("uInside", around);
        shader.set("uInsideCount", static_cast<int>(around.size()));
        shader.set("uUnusual", unusual);
        shader.set("uUnusualCount", static_cast<int>(unusual.size()));
    }
};

Result<LayerPeeling::Targets> LayerPeeling::Targets::create(const gl::Functions& gl, int faceSize) {
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
    return targets;
}

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
    build(peeling.sides_, "cubemap/peel.vert", "cubemap/peel_sides.frag");
    build(peeling.count_, "cubemap/peel.vert", "cubemap/count_layers.frag");
    build(peeling.entry_, "cubemap/peel.vert", "cubemap/peel_entry.frag");
    build(peeling.exit_, "cubemap/peel.vert", "cubemap/peel_exit.frag");
    build(peeling.pack_, "fullscreen.vert", "cubemap/pack_interval.frag");
    if (!status) {
        return status;
    }
    return peeling;
}

void LayerPeeling::surveySides(const FaceCapture& faces, Targets& targets, int faceSize,
                               std::array<bool, kFaces>& modelled, const gl::Functions& gl) {
    clear(gl, targets.exits, kNothing);
    sides_.bind();
    faces.draw(sides_);
    std::vector<float> texels(static_cast<std::size_t>(kFaces * faceSize * faceSize));
    targets.exits.beginRead(0);
    gl.ReadPixels(0, 0, kFaces * faceSize, faceSize, GL_RED, GL_FLOAT, texels.data());
    std::map<int, Sides> seen;
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const int side = static_cast<int>(texels[i]);
        const std::size_t face = i / static_cast<std::size_t>(faceSize) % kFaces;
        modelled[face] = modelled[face] || side >= 0;
        if (side > 0) {
            Sides& sides = seen[side / 2];
            ++(side % 2 != 0 ? sides.front : sides.back);
        }
    }
    targets.unusual = unusualSheets(seen);
}

Result<int> LayerPeeling::countLayers(const FaceCapture& faces, const Targets& targets,
                                      int faceSize, int most, const gl::Functions& gl) {
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
    targets.setUniforms(count_);
    faces.draw(count_);
    gl.Disable(GL_BLEND);
    std::vector<std::uint8_t> texels(static_cast<std::size_t>(kFaces * faceSize * faceSize));
    counts->beginRead(0);
    gl.ReadPixels(0, 0, kFaces * faceSize, faceSize, GL_RED, GL_UNSIGNED_BYTE, texels.data());
    const int deepest = *std::max_element(texels.begin(), texels.end());
    return std::clamp(deepest, 1, most);
}

void LayerPeeling::peelEntries(const FaceCapture& faces, const Targets& targets,
                               const gl::RenderToTexture2D* previous,
                               const gl::RenderToTexture2D& entry, const gl::Functions& gl) {
    clear(gl, entry, kNothing);
    entry_.bind();
    if (previous != nullptr) {
        previous->bindTexture(0, 0);
        targets.exits.bindTexture(0, 1);
    }
    entry_.set("uPrevious", 0);
    entry_.set("uExit", 1);
    entry_.set("uFirstLayer", previous == nullptr ? 1 : 0);
    targets.setUniforms(entry_);
    faces.draw(entry_);
}

void LayerPeeling::peelExits(const FaceCapture& faces, const Targets& targets,
                             const gl::RenderToTexture2D& entry, const gl::Functions& gl) {
    clear(gl, targets.exits, kNoExit);
    exit_.bind();
    entry.bindTexture(0, 0);
    exit_.set("uEntry", 0);
    targets.setUniforms(exit_);
    faces.draw(exit_);
}

Result<LayerPeeling::Layers> LayerPeeling::capture(const BackboneContext& context,
                                                   const SceneGeometry& geometry,
                                                   const CubeMapProjector& projector,
                                                   const DistanceRange& range, int most) {
    const gl::DebugGroup group(context.gl, "aolib: peel layers");
    const gl::Functions& gl = context.gl;
    const int faceSize = projector.tiles.faceSize();
    auto made = Targets::create(gl, faceSize);
    if (!made) {
        return made.status();
    }
    Targets& targets = *made;
    targets.around = geometry.solidsAround(context.scene, projector.position());
    targets.around.resize(std::min(targets.around.size(), kMostAround));

    Layers layers;
    const FaceCapture faces(context, geometry, projector, range);
    gl::RenderToTexture2D* entry = &targets.entries[0];
    gl::RenderToTexture2D* next = &targets.entries[1];
    surveySides(faces, targets, faceSize, layers.modelled, gl);
    const auto count = countLayers(faces, targets, faceSize, most, gl);
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
    const gl::RenderToTexture2D* previous = nullptr;
    for (int layer = 0; layer < *count; ++layer) {
        peelEntries(faces, targets, previous, *entry, gl);
        peelExits(faces, targets, *entry, gl);
        layers.intervals.begin(layer);
        pack_.bind();
        entry->bindTexture(0, 0);
        targets.exits.bindTexture(0, 1);
        pack_.set("uEntry", 0);
        pack_.set("uExit", 1);
        context.generated.drawFullscreen();
        previous = entry;
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
