#include "bake/scatter/ThinTexels.h"

#include <algorithm>

namespace aolib::bake {

namespace {

/// Of a texel's area: with less, neighbours help.
constexpr float coveredEnough = 0.15F;
/// What the coverage of texels is summed from is too coarse for less.
constexpr float least = 1e-3F;

} // namespace

glm::vec4 lightPerCoverage(const TexelSums& sums, std::size_t texel) {
    glm::vec4 light = sums.light[texel];
    float covered = sums.coverage[texel];
    if (covered < coveredEnough) {
        const auto width = static_cast<std::size_t>(sums.size.x);
        const int x = static_cast<int>(texel % width);
        const int y = static_cast<int>(texel / width);
        glm::vec4 lightAbout(0.0F);
        float coveredAbout = 0.0F;
        for (int v = std::max(0, y - 1); v <= std::min(sums.size.y - 1, y + 1); ++v) {
            for (int u = std::max(0, x - 1); u <= std::min(sums.size.x - 1, x + 1); ++u) {
                const std::size_t other =
                    static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u);
                if (other != texel && sums.facets[other] == sums.facets[texel]) {
                    lightAbout += sums.light[other];
                    coveredAbout += sums.coverage[other];
                }
            }
        }
        if (coveredAbout > 0.0F) {
            const float share = std::min(1.0F, (coveredEnough - covered) / coveredAbout);
            light += share * lightAbout;
            covered += share * coveredAbout;
        }
    }
    return covered >= least ? light / covered : glm::vec4(0.0F);
}

} // namespace aolib::bake
