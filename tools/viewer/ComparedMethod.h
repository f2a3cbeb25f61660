#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace aolib::viewer {

/// What the right part of a split picture shows.
enum class ComparedMethod : std::uint8_t {
    None,        ///< no split
    Host,        ///< the host's picture, without ambient occlusion
    ScreenSpace, ///< the backbone that works on the host's view alone
    Truth,       ///< ray traced
    Difference,  ///< of the left part's W and the truth's
    Environment, ///< the scene by the light of an environment map
};

/// A compared by name.
struct ComparedMethodChoice {
    ComparedMethod value;
    std::string_view name;  ///< as the command line spells it
    std::string_view label; ///< as the window shows it
};

/// Every compared, in the order in which a key goes through them.
inline constexpr std::array kComparedMethods{
    ComparedMethodChoice{ComparedMethod::None, "none", "nothing"},
    ComparedMethodChoice{ComparedMethod::Host, "host", "without ambient occlusion"},
    ComparedMethodChoice{ComparedMethod::ScreenSpace, "screenspace", "screen space"},
    ComparedMethodChoice{ComparedMethod::Truth, "truth", "ray-traced truth"},
    ComparedMethodChoice{ComparedMethod::Difference, "difference", "difference from truth"},
    ComparedMethodChoice{ComparedMethod::Environment, "environment", "light of an environment"}};

inline constexpr const ComparedMethodChoice& choiceOf(ComparedMethod compared) {
    return kComparedMethods[static_cast<std::size_t>(compared)];
}
/// Whether a truth is needed to show it.
inline constexpr bool needsTruth(ComparedMethod compared) {
    return compared == ComparedMethod::Truth || compared == ComparedMethod::Difference;
}

} // namespace aolib::viewer
