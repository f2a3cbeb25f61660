#pragma once

#include <map>
#include <optional>
#include <vector>

#include "backbone/texels/AbstractCapture.h"
#include "backbone/texels/LayerPeeling.h"
#include "gl/PixelReadback.h"
#include "gl/TextureStack.h"

namespace aolib {

/// Layers of solid intervals [entry, exit] along each texel's ray, nearest first. The intervals are
/// counted before, so that no more layers are made than there are. Faces, and the view if there is
/// one, are peeled one after the other; a unit is one pass over one of them.
class LayerCapture final : public AbstractCapture {
public:
    static constexpr int kMostLayers = 8;

    /// @param around   the solids that contain the centre (SceneGeometry::enclosingSolids())
    /// @param peeling  outlives the capture.
    /// @param most     layers at most, 1 to kMostLayers.
    LayerCapture(const BackboneContext& context, const FaceCapture& faces,
                 std::vector<float> around, LayerPeeling& peeling, int most);

    bool complete() const override { return stage_ == Stage::Complete; }
    WorkUnit next() const override;
    bool waits() const override;
    AoStatus step() override;
    void bind(gl::GLSLShader& shader) const override;
    std::array<bool, kFaces> modelled() const override;
    int layersOf(int face) const override { return counts_[static_cast<std::size_t>(face)]; }
    int layers() const override;
    std::size_t bytes() const override;
    std::size_t mostBytes() const override { return mostBytes_; }

private:
    enum class Stage { Targets, Sides, ReadSides, Count, ReadCounts, Layers, Peel, Complete };
    /// How many texels show the front and the back of an open mesh.
    struct Sides {
        std::size_t front = 0;
        std::size_t back = 0;
    };
    /// Where one face is drawn before it is packed.
    struct Targets {
        std::array<gl::RenderToTexture2D, 2> entries; ///< distance, solid, octahedral normal
        gl::RenderToTexture2D exits;
        gl::RenderToTexture2D counts;
        std::vector<gl::PixelReadback> readbacks; ///< of each face of this size

        std::size_t bytes() const;
    };

    static constexpr std::size_t kAll = kFaces + 1; ///< faces, the view's last
    /// Faces of the cube, and the view's, have targets and layers of their own size.
    static std::size_t sizeOf(int face) { return face < kFaces ? 0 : 1; }

    AoStatus makeTargets();
    AoStatus makeTargets(Targets& made, const glm::ivec2& size, std::size_t faces) const;
    Targets& targets() { return (*targets_)[sizeOf(face_)]; }
    gl::PixelReadback& readback() { return targets().readbacks[face_ < kFaces ? at() : 0]; }
    void drawSides();
    AoStatus readSides();
    void drawCount();
    AoStatus readCount();
    AoStatus makeLayers();
    /// Half a layer of a face.
    void peel();
    int firstLayer(int face) const;
    /// Goes on to the next face, or else to the next stage.
    void nextFace();
    std::vector<float> unusualOpenMeshes() const;
    std::size_t at() const { return static_cast<std::size_t>(face_); }

    const BackboneContext context_;
    const FaceCapture faces_;
    LayerPeeling& peeling_;
    const int most_;

    Stage stage_ = Stage::Targets;
    int face_ = 0;
    int layer_ = 0;
    bool entered_ = false; ///< the layer's entries are peeled, its exits are not
    std::optional<std::array<Targets, 2>> targets_;
    std::map<int, Sides> seen_; ///< of each open mesh
    LayerPeeling::Marks marks_;
    std::array<int, kAll> counts_{}; ///< intervals along a ray, at most; 0 without geometry
    /// Entry (-1 none), exit, octahedral normal: each face's, and the view's.
    std::array<gl::TextureStack, 2> intervals_;
    std::size_t mostBytes_ = 0;
};

} // namespace aolib
