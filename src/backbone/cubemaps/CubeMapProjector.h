#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <aolib/Statistics.h>

#include "backbone/cubemaps/Eviction.h"
#include "backbone/cubemaps/TexelAtlas.h"
#include "backbone/cubemaps/TileTable.h"
#include "gl/GpuTimer.h"
#include "scene/Bounds.h"

namespace aolib {

/// A cube map that stands in the scene and projects its ambient occlusion onto it (thesis 4.4). Its
/// texels lie in the atlas; only faces that hold geometry have any.
class CubeMapProjector {
public:
    /// Where a cube map is in its life.
    ///
    ///     Queued -> Filling -> FadingIn -> Visible -> FadingOut     (then it is removed)
    ///                             |           |           |
    ///     any state that is shown +-----------+-----------+-> Stale -> FadingIn or Visible
    ///
    /// Changes of the scene do not change the state: they mark single tiles as outdated, which are
    /// shown until they are replaced.
    enum class State : std::uint8_t {
        Queued,    ///< not shown; nothing of it counts, and computing has not begun
        Filling,   ///< not shown; the first passes of its tiles are computed
        FadingIn,  ///< shown; its quality rises to its own
        Visible,   ///< shown with its own quality
        Stale,     ///< shown; all of it is to be computed anew
        FadingOut, ///< shown; its quality falls, then it is evicted
    };
    static constexpr int kNoLayer = -1;

    /// Makes a cube map that is Queued. @param pinned  the host placed it
    /// Errors: MissingCapability, OutOfMemory.
    static Result<CubeMapProjector> create(const gl::Functions& gl, TexelAtlas& atlas, CubeMapId id,
                                           const glm::vec3& position, bool pinned);

    CubeMapId id() const { return id_; }
    /// World units.
    const glm::vec3& position() const { return position_; }
    bool isPinned() const { return pinned_; }

    // ---- State

    State state() const { return state_; }
    bool isVisible() const { return state_ != State::Queued && state_ != State::Filling; }
    /// Whether all of it is to be computed anew.
    bool mustBegin() const { return state_ == State::Queued || state_ == State::Stale; }
    /// Added to log2 of its quality: 0, or less while it fades, so that it shades only what no
    /// other cube map covers.
    float fade() const { return fade_; }
    bool isFadedOut() const;

    /// To Queued or Stale: nothing that it holds counts any more.
    void invalidate() { state_ = isVisible() ? State::Stale : State::Queued; }
    /// To Queued, with other texels along a face's edge. All texels are dropped.
    void resize(int faceSize);
    /// From Queued to Filling, from Stale to FadingIn or Visible; others stay.
    void begin();
    /// From Filling to FadingIn or Visible; others stay.
    void show();
    /// From any state that is shown to FadingOut.
    void fadeOut() { state_ = State::FadingOut; }
    /// Ends the frame's part of a fade, if there is one. A new cube map fades in once its tiles
    /// have had `passes`.
    void stepFade(int passes);
    /// From FadingIn to Visible at once. One that is not shown yet will not fade in.
    void endFade();

    // ---- Tiles

    const TileTable& tiles() const { return tiles_; }
    /// Sets the number of the frame in which passes are recorded from now on.
    void setFrame(std::uint64_t frame);
    /// As TileTable::request().
    void request(int face, const glm::vec2& at, int passesPerPage, TileSet& requested) {
        tiles_.request(face, at, passesPerPage, &requested);
    }
    void requestAll() { tiles_.requestAll(); }
    /// Marks what a change of the scene has altered.
    void setOutdated(int tile) { tiles_.setOutdated(tile); }
    void setAllOutdated() { tiles_.setAllOutdated(); }
    void restartTile(int tile) { tiles_.restart(tile); }
    /// Records how many passes a tile's texels have had.
    void recordPasses(int tile, int passes) { tiles_.setPasses(tile, passes); }
    /// Records that a tile holds texels, of whose passes none count.
    void recordOutdatedTexels(int tile) { tiles_.setKnown(tile); }
    /// Records how many passes a tile's pages have had.
    void recordPagePasses(int tile, int passes) { tiles_.setPagePasses(tile, passes); }
    void setAvailablePages(int tile, int count) { tiles_.setAvailablePages(tile, count); }
    void denyPages(int tile) { tiles_.denyPages(tile); }
    void clearDeniedPages() { tiles_.clearDeniedPages(); }
    /// Whether a region may lie before or behind a tile's texels.
    bool looksAt(int tile, const Bounds& region) const;
    /// The tiles that look at a region, and perhaps some beside them.
    std::vector<int> tilesTowards(const Bounds& region) const;

    // ---- Texels

    /// What the code of depths along a face's axis spans (shaders/shared/distance_code.h).
    const glm::vec2& depthCode() const { return depthCode_; }
    /// Makes the code span distances from the centre, world units; a code that spans them already
    /// stays. Texels of another code are dropped, and their tiles restarted. A code that was
    /// exceeded once leaves room beyond: it is exceeded a few times at most, however far things
    /// move.
    /// @return whether the code is another now.
    bool spanDistances(float nearest, float farthest);
    /// Allocates the layer of a face, where it has none. Errors: as FaceStore::allocateReserved().
    AoStatus allocateFace(int face);
    /// Allocates the layers of these faces, and releases the others.
    AoStatus allocateFaces(const std::array<bool, kFaces>& modelled);
    void releaseFaces();
    bool hasFace(int face) const { return layer(face) != kNoLayer; }
    int layer(int face) const { return layers_[static_cast<std::size_t>(face)]; }
    int facesAllocated() const;

    /// The first page of a tile, allocated on first use. Errors: as PageStore::allocate().
    Result<int> firstPage(int tile);
    /// Allocates one more page, behind those that a tile has. Errors: as PageStore::allocate().
    Result<int> addPage(int tile);
    void releasePages();
    void releasePages(int tile);
    /// Releases the pages of tiles that look towards a region: something there has changed.
    void releasePages(const Bounds& region);

    /// Records that texels of surfaces behind others are shown for the first time: feedback of
    /// earlier frames does not hold what is hidden still.
    void recordHiddenLayers() { hiddenLayersIn_ = frame_; }
    /// Whether feedback of a frame was given after the latest recordHiddenLayers().
    bool isSeenBy(std::uint64_t frame) const { return frame >= hiddenLayersIn_; }

    // ---- What it costs and what it is worth

    void recordCapture(int layers, std::size_t bytes);
    void resetBuildTime() { buildMs_ = 0.0; }
    void addBuildTime(double milliseconds) { buildMs_ += milliseconds; }
    gl::GpuTimer& timer() { return timer_; }

    const CubeMapUsage& usage() const { return usage_; }
    /// Records the share of a view's surfaces that it is the best for.
    void recordUsage(float share) { usage_.record(share, fade_ >= 0.0F); }

    /// Reads everything back; waits for the GPU.
    CubeMapImage read(const gl::Functions& gl) const;
    CubeMapInfo info();

private:
    CubeMapProjector(TexelAtlas& atlas, CubeMapId id, const glm::vec3& position, bool pinned,
                     gl::GpuTimer timer);

    void becomeVisible() { state_ = fade_ < 0.0F ? State::FadingIn : State::Visible; }
    void releaseFace(int face);
    void release(int tile, const std::vector<int>& pages);

    TexelAtlas* atlas_;
    CubeMapId id_;
    glm::vec3 position_;
    bool pinned_;
    State state_ = State::Queued;
    float fade_;
    TileTable tiles_;
    std::uint64_t frame_ = 0;
    std::uint64_t hiddenLayersIn_ = 0;                       ///< number of a frame
    float nearest_ = std::numeric_limits<float>::infinity(); ///< of the depths that codes span
    float farthest_ = 0.0F;
    glm::vec2 depthCode_{0.0F, 0.0F};
    std::map<int, std::vector<int>> pages_; ///< by tile, front to back
    std::array<int, kFaces> layers_{kNoLayer, kNoLayer, kNoLayer, kNoLayer, kNoLayer, kNoLayer};
    CubeMapUsage usage_;
    int captured_ = 0;             ///< solid intervals captured along a ray, at most
    std::size_t captureBytes_ = 0; ///< GPU memory that the last build took and released
    double buildMs_ = 0.0;
    gl::GpuTimer timer_;
};

} // namespace aolib
