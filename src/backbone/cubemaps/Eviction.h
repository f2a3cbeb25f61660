#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <aolib/Options.h>

namespace aolib {

/// What a cube map is worth to the views.
struct CubeMapUsage {
    float usefulness = 1.0F;  ///< running mean of the share of surfaces that it is the best for
    int feedbackUnseen = 0;   ///< results of the feedback pass since it was the best for any
    int feedbackComplete = 0; ///< results since it faded in

    /// Records a result of the feedback pass.
    /// @param share     of the view's surfaces that it is the best for
    /// @param complete  it has faded in
    void record(float share, bool complete);
};

/// What room is made for.
enum class EvictionReason : std::uint8_t {
    NewCubeMap,
    Page,   ///< of a cube map that is seen: only those that no view has shown lately give way
    Budget, ///< which has shrunk: even pinned ones give way
};

/// Decides which cube map gives way where the memory budget has no room for another. No GL.
class Eviction {
public:
    /// Layers of the face store that the budget has room for, at most `most`.
    static int layersWithin(const CubeMapOptions& options, int most);

    /// A cube map that may give way.
    struct Candidate {
        bool pinned = false;    ///< the host placed it
        bool fadingOut = false; ///< it was chosen before
        bool inUse = false;     ///< by the frame
        CubeMapUsage usage;
    };
    /// The number of the candidate that is missed least; none where none may go. Pinned ones stay,
    /// and so does what is in use and has been complete for a short time only: what was computed is
    /// shown before it is evicted.
    static std::optional<std::size_t> victim(std::span<const Candidate> candidates,
                                             EvictionReason reason);
};

} // namespace aolib
