#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <aolib/Statistics.h>

#include "backbone/Frame.h"
#include "backbone/cubemapped/BlockStore.h"
#include "backbone/cubemapped/FaceStore.h"
#include "backbone/cubemapped/TileProgress.h"
#include "gl/GpuTimer.h"
#include "scene/Bounds.h"

namespace aolib {

/// A cube map that stands in the scene and projects its ambient occlusion onto it (thesis 4.4). Its
/// texels lie in the face store; only faces that hold geometry have any.
class CubeMapProjector {
public:
    static constexpr int kNoLayer = -1;
    /// What a new cube map's quality lacks, in log2, until it has come in: it then shades only what
    /// no other knows.
    static constexpr float kNewcomer = -8.0F;

    /// Errors: MissingCapability, OutOfMemory.
    static Result<CubeMapProjector> create(const gl::Functions& gl, CubeMapId id,
                                           const glm::vec3& position, int faceSize);

    CubeMapId id() const { return id_; }
    /// World units.
    const glm::vec3& position() const { return position_; }

    /// What the code of depths along a face's axis spans (shaders/shared/distance_code.h).
    const glm::vec2& depthCode() const { return depthCode_; }
    /// Makes the code span distances from the centre, world units; a code that spans them already
    /// stays. What was kept by another code is dropped, and its tiles begin anew. A code that was
    /// exceeded once leaves room beyond: it is exceeded a few times at most, however far things
    /// move.
    /// @return whether the code is another now.
    bool spanDistances(FaceStore& store, BlockStore& blocks, float nearest, float farthest);

    /// Makes room for a face that holds geometry. Errors: as FaceStore::take().
    AoStatus keepFace(FaceStore& store, int face);
    /// The same for all of them; those without geometry are given back.
    AoStatus keepFaces(FaceStore& store, const std::array<bool, kFaces>& modelled);
    /// Gives all layers back; nothing is known any more.
    void dropFaces(FaceStore& store);
    void dropFace(FaceStore& store, int face);
    bool keeps(int face) const { return layers_[static_cast<std::size_t>(face)] != kNoLayer; }
    int layer(int face) const { return layers_[static_cast<std::size_t>(face)]; }
    int facesKept() const;

    /// The first block of a tile, made on first use.
    /// Errors: as BlockStore::take().
    Result<int> blockOf(const FaceStore& store, BlockStore& blocks, int tile);
    /// One more block, behind those that a tile has: surfaces behind surfaces.
    Result<int> addBlock(const FaceStore& store, BlockStore& blocks, int tile);
    void dropBlocks(const FaceStore& store, BlockStore& blocks);
    /// Those of a tile.
    void dropBlocks(const FaceStore& store, BlockStore& blocks, int tile);
    /// Those of tiles that look towards a region: something there has changed.
    void dropBlocks(const FaceStore& store, BlockStore& blocks, const Bounds& region);
    /// Whether a region may lie before or behind a tile's texels.
    bool looksAt(int tile, const Bounds& region) const;
    /// The tiles that look at a region, and perhaps some beside them.
    std::vector<int> tilesTowards(const Bounds& region) const;

    /// Reads everything back; waits for the GPU.
    CubeMapImage read(const gl::Functions& gl, const FaceStore& store) const;
    CubeMapInfo info(const FaceStore& store);

    /// What it is worth, for Eviction to weigh.
    struct Use {
        bool byHand = false;     ///< the host placed it
        bool retiring = false;   ///< it fades out, then it goes
        float usefulness = 1.0F; ///< running mean of the share of surfaces that it is the best for
        int surveysUnseen = 0;   ///< since it was the best for any
        int surveysComplete = 0; ///< since it came in
    };
    Use use;

    TileProgress tiles;
    /// It shows more than before: surveys so far do not tell what it still hides.
    bool showsMore = false;
    std::uint64_t shownMoreIn = 0; ///< number of the frame in which it last showed more
    /// What is kept, or on its way, is of no use: compute all of it before the next use.
    bool dirty = true;
    /// Some of its tiles are outdated: compute these again as soon as what is on its way allows.
    bool outdated = false;
    /// Each tile that was asked for has had its first passes: it may be shown.
    bool shown = false;
    float bias = kNewcomer;       ///< added to log2 of its quality; 0 once it has come in
    int captured = 0;             ///< solid intervals captured along a ray, at most
    std::size_t captureBytes = 0; ///< GPU memory that the last build took and gave back
    double buildMs = 0.0;
    gl::GpuTimer timer;

private:
    void giveBack(const FaceStore& store, BlockStore& blocks, int tile,
                  const std::vector<int>& dropped);

    CubeMapId id_{};
    glm::vec3 position_{};
    float nearest_ = std::numeric_limits<float>::infinity(); ///< of the depths that codes span
    float farthest_ = 0.0F;
    glm::vec2 depthCode_{0.0F, 0.0F};
    std::map<int, std::vector<int>> blocks_; ///< by tile, front to back
    std::array<int, kFaces> layers_{kNoLayer, kNoLayer, kNoLayer, kNoLayer, kNoLayer, kNoLayer};
};

} // namespace aolib
