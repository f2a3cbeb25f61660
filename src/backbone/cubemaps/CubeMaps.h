#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "backbone/cubemaps/CubeMapProjector.h"
#include "backbone/frame/Frame.h"

namespace aolib {

/// The cube maps that stand in the scene, what they keep, and the room that the memory budget has
/// for them.
class CubeMaps {
public:
    using Removed = std::function<void(CubeMapProjector&)>;

    /// @param context  outlives it.
    /// @param removed  is called with each cube map before its removal.
    CubeMaps(const BackboneContext& context, Removed removed);

    TexelAtlas& atlas() { return atlas_; }
    const TexelAtlas& atlas() const { return atlas_; }

    const std::vector<std::unique_ptr<CubeMapProjector>>& all() const { return projectors_; }
    /// Null where none has the id.
    CubeMapProjector* find(CubeMapId id) const;
    /// The ones to work on in a frame, as many as the options say, nearest first.
    std::vector<CubeMapProjector*> nearest(const glm::vec3& camera) const;

    /// Follows the options' face size and memory budget, and what their estimator needs pages for.
    void followOptions();
    /// Adds a cube map without computed texels. Precondition: there is room for another.
    /// Errors: as CubeMapProjector::create().
    Result<CubeMapProjector*> add(const glm::vec3& position, bool pinned);
    void remove(CubeMapProjector& projector);

    /// Makes room for one more. Errors: OutOfMemory (pinned ones take all of it).
    AoStatus makeRoomAtOnce();
    /// Makes room within some frames: what is in view fades out before it is evicted.
    /// @param used    by the frame.
    /// @param atOnce  nothing fades.
    /// @return whether there is room now.
    bool makeRoom(EvictionReason reason, const std::vector<CubeMapProjector*>& used, bool atOnce);
    /// Evicts cube maps that have faded out, and makes room for visible pages.
    void evictWhereDue(const std::vector<CubeMapProjector*>& used, bool atOnce);
    /// Number of cube maps evicted for the memory budget.
    std::uint64_t evicted() const { return evicted_; }

    /// Records which share of a view's surfaces each cube map is the best for; 0 for those that are
    /// not named.
    void recordUsage(const std::map<CubeMapId, float>& best);

private:
    /// The least useful evictable cube map; null if none is evictable.
    CubeMapProjector* victim(const std::vector<CubeMapProjector*>& used,
                             EvictionReason reason) const;
    void evict(CubeMapProjector& projector);
    void clearDeniedPages();

    const BackboneContext context_;
    Removed removed_;
    TexelAtlas atlas_;
    std::vector<std::unique_ptr<CubeMapProjector>> projectors_;
    std::uint32_t nextId_ = 1;
    std::uint64_t evicted_ = 0;
};

} // namespace aolib
