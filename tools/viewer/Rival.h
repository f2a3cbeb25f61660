#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace aolib::viewer {

/// What the right part of a split picture shows.
enum class Rival : std::uint8_t {
    None,        ///< no split
    Host,        ///< the host's picture, without ambient occlusion
    ScreenSpace, ///< the backbone that works on the host's view alone
    Truth,       ///< ray traced
    Difference,  ///< of the left part's W and the truth's
    Environment, ///< the scene by the light of an environment map
};

/// A rival by name.
struct RivalChoice {
    Rival value;
    std::string_view name;  ///< as the command line spells it
    std::string_view label; ///< as the window shows it
};

/// Every rival, in the order in which a key goes through them.
inline constexpr std::array kRivals{
    RivalChoice{Rival::None, "none", "nothing"},
    RivalChoice{Rival::Host, "host", "without ambient occlusion"},
    RivalChoice{Rival::ScreenSpace, "screenspace", "screen space"},
    RivalChoice{Rival::Truth, "truth", "ray-traced truth"},
    RivalChoice{Rival::Difference, "difference", "difference from truth"},
    RivalChoice{Rival::Environment, "environment", "light of an environment"}};

inline constexpr const RivalChoice& choiceOf(Rival rival) {
    return kRivals[static_cast<std::size_t>(rival)];
}
/// Whether a truth is needed to show it.
inline constexpr bool needsTruth(Rival rival) {
    return rival == Rival::Truth || rival == Rival::Difference;
}

} // namespace aolib::viewer
