#pragma once

#include <cstdint>

#include <aolib/Options.h>
#include <aolib/Status.h>

namespace aolib::bake {

/// How far occluders reach. A weight w(L) that falls from 1 with the distance is a mixture of
/// steps, w(L) = P(r > L): each direction has a step's radius r of its own, drawn from that
/// distribution, and the mean over directions is the weight's.
struct Reach {
    double radius = 0.0; ///< frame units; 0 has no end
    Falloff falloff = Falloff::Step;

    bool endless() const { return radius <= 0.0 || falloff == Falloff::Off; }
};

/// The radius of a direction, frame units: what is nearer than that occludes; infinite where
/// occluders have no end. Falloff::Exp takes its radii from one more dimension of the sequence of
/// directions, and none below a 64th of its radius.
double drawRadius(const Reach& reach, std::uint32_t seed, std::uint32_t index);

/// Errors: InvalidOption, naming the least radius, where a scene would be cut into too many slabs.
/// @param scale  frame units per world unit.
AoStatus checkReach(const Reach& reach, double scale);

} // namespace aolib::bake
