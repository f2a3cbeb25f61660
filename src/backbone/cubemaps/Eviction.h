#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <aolib/Options.h>

namespace aolib {

/// Usefulness of a cube map to the views.
struct CubeMapUsage {
    float usefulness = 1.0F;  ///< running mean of the share of surfaces that it is the best for
    int feedbackUnseen = 0;   ///< results of the feedback pass since it was the best for any
    int feedbackComplete = 0; ///< results since it faded in

    /// Records a result of the feedback pass.
    /// @param share     of the view's surfaces that it is the best for
    /// @param complete  it has faded in
    void record(float share, bool complete);
};

/// The purpose of an eviction.
enum class EvictionReason : std::uint8_t {
    NewCubeMap,
    Page,   ///< of a cube map that is seen: only those that no view has shown lately give way
    Budget, ///< which has shrunk: even pinned ones give way
};

/// Chooses the cube map to evict when the memory budget has no room for another. No GL.
class Eviction {
public:
    /// Layers of the face store that the budget has room for, at most `most`.
    static int layersWithin(const CubeMapOptions& options, int most);

    /// A cube map that may be evicted.
    struct Candidate {
        bool pinned = false;    ///< the host placed it
        bool fadingOut = false; ///< it was chosen before
        bool inUse = false;     ///< by the frame
        CubeMapUsage usage;
    };
    /// Returns the index of the least useful evictable candidate; none if none is evictable.
    /// With EvictionReason::Budget, every candidate is evictable.
    /// Otherwise not evictable: pinned cube maps, and cube maps in use that have only just become
    /// complete, so that computed texels are shown before eviction.
    static std::optional<std::size_t> victim(std::span<const Candidate> candidates,
                                             EvictionReason reason);
};

} // namespace aolib
