#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include <aolib/Options.h>

#include "backbone/cubemapped/CubeMapProjector.h"

namespace aolib {

/// Decides which cube map gives way where the memory budget has no room for another. No GL.
class Eviction {
public:
    /// Layers of the face store that the budget has room for, at most `most`.
    static int layersWithin(const CubeMapOptions& options, int most);

    /// Follows how useful cube maps are.
    /// @param best  share of the surfaces in the latest view that each is the best for; none for
    ///              those that are best nowhere.
    static void follow(std::span<const std::unique_ptr<CubeMapProjector>> cubeMaps,
                       const std::map<CubeMapId, float>& best);

    enum class For : std::uint8_t {
        Newcomer, ///< another cube map
        Block,    ///< of one that is seen: only cube maps that nobody has seen of late give way
        Budget,   ///< which has shrunk: even those placed by hand give way
    };
    /// The cube map that is missed least, null where none may go. Those placed by hand stay, and so
    /// does what is in use and has not been complete for some time: what was computed is shown
    /// before it is thrown away.
    /// @param used  by the frame.
    static CubeMapProjector* victim(std::span<const std::unique_ptr<CubeMapProjector>> cubeMaps,
                                    const std::vector<CubeMapProjector*>& used, For reason);
};

} // namespace aolib
