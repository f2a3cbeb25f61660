#pragma once

#include <utility>
#include <vector>

#include "HostKinds.h"
#include "image/Image.h"

namespace aolib::test {

/// The ray-traced pictures of cameras, each traced once.
class TracedKinds {
public:
    explicit TracedKinds(const Model& model) : model_(model) {}

    /// W of what a camera sees, background -1.
    /// @param offset  of the rays from the pixels' centres, pixels.
    FloatImage of(const CameraKind& camera, const glm::dvec2& offset = glm::dvec2(0.0));

private:
    const Model& model_;
    std::vector<std::pair<glm::dmat4, FloatImage>> known_;
};

} // namespace aolib::test
