#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "backbone/Frame.h"
#include "backbone/cubemapped/BlockStore.h"
#include "backbone/cubemapped/CubeMapProjector.h"
#include "backbone/cubemapped/Eviction.h"
#include "backbone/cubemapped/FaceStore.h"

namespace aolib {

/// The cube maps that stand in the scene, what they keep, and the room that the memory budget has
/// for them.
class CubeMaps {
public:
    using Removed = std::function<void(CubeMapProjector&)>;

    /// @param context  outlives it.
    /// @param removed  is told of each one before it goes.
    CubeMaps(const BackboneContext& context, Removed removed);

    FaceStore& store() { return store_; }
    const FaceStore& store() const { return store_; }
    BlockStore& blocks() { return blocks_; }
    const BlockStore& blocks() const { return blocks_; }

    const std::vector<std::unique_ptr<CubeMapProjector>>& all() const { return projectors_; }
    /// Null where none has the id.
    CubeMapProjector* find(CubeMapId id) const;
    /// The ones to work on in a frame, as many as the options say, nearest first.
    std::vector<CubeMapProjector*> nearest(const glm::vec3& camera) const;

    /// Follows the options' face size and memory budget, and what their estimator needs blocks for.
    void followOptions();
    /// One more, of which nothing is computed yet. There must be room for it.
    /// Errors: as CubeMapProjector::create().
    Result<CubeMapProjector*> add(const glm::vec3& position, bool byHand);
    void remove(CubeMapProjector& projector);

    /// Makes room for one more. Errors: OutOfMemory (those placed by hand take all of it).
    AoStatus makeRoomAtOnce();
    /// Makes room within some frames: what is in view fades out before it goes.
    /// @param used    by the frame.
    /// @param atOnce  nothing fades.
    /// @return whether there is room now.
    bool makeRoom(Eviction::For reason, const std::vector<CubeMapProjector*>& used, bool atOnce);
    /// Has those go that have faded out, and makes room for blocks that are in view.
    void evictWhereDue(const std::vector<CubeMapProjector*>& used, bool atOnce);
    /// How many went for the budget's sake.
    std::uint64_t evicted() const { return evicted_; }

private:
    void evict(CubeMapProjector& projector);
    void allowBlocks();

    const BackboneContext context_;
    Removed removed_;
    FaceStore store_;
    BlockStore blocks_;
    std::vector<std::unique_ptr<CubeMapProjector>> projectors_;
    std::uint32_t nextId_ = 1;
    std::uint64_t evicted_ = 0;
};

} // namespace aolib
