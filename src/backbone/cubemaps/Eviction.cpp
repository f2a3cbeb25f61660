#include "backbone/cubemaps/Eviction.h"

#include <algorithm>
#include <cmath>

#include "backbone/cubemaps/FaceStore.h"

namespace aolib {

namespace {

/// Weight of a feedback result in the running mean of usefulness: the last hundred make most of
/// it. It falls on while no view shows the cube map, so that the longest unseen are evicted first.
constexpr float kWeight = 1.0F / 64.0F;
/// Feedback results for which a complete cube map stays in any case, so that two views that need
/// more than there is room for do not evict each other's from frame to frame.
constexpr int kStay = 32;
/// Feedback results in which a cube map was best nowhere until a page that is seen is worth more.
constexpr int kUnseen = 32;

constexpr double kMiB = 1024.0 * 1024.0;

bool isEvictable(const Eviction::Candidate& one, EvictionReason reason) {
    if (reason == EvictionReason::Budget) {
        return true;
    }
    const bool settled = !one.inUse || one.fadingOut || one.usage.feedbackComplete >= kStay;
    const bool unseen = reason == EvictionReason::NewCubeMap || one.usage.feedbackUnseen >= kUnseen;
    return !one.pinned && settled && unseen;
}

/// Whether the first is missed less.
bool missedLess(const Eviction::Candidate& a, const Eviction::Candidate& b) {
    if (a.pinned != b.pinned) {
        return b.pinned;
    }
    if (a.fadingOut != b.fadingOut) {
        return a.fadingOut;
    }
    return a.usage.usefulness < b.usage.usefulness;
}

} // namespace

void CubeMapUsage::record(float share, bool complete) {
    usefulness += kWeight * (share - usefulness);
    feedbackUnseen = share > 0.0F ? 0 : feedbackUnseen + 1;
    feedbackComplete += complete ? 1 : 0;
}

int Eviction::layersWithin(const CubeMapOptions& options, int most) {
    if (options.memoryBudget <= 0.0F) {
        return most;
    }
    const double layers =
        std::floor(double{options.memoryBudget} * kMiB /
                   static_cast<double>(FaceStore::bytesPerLayer(options.faceSize)));
    return static_cast<int>(std::min(layers, static_cast<double>(most)));
}

std::optional<std::size_t> Eviction::victim(std::span<const Candidate> candidates,
                                            EvictionReason reason) {
    std::optional<std::size_t> least;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (isEvictable(candidates[i], reason) &&
            (!least || missedLess(candidates[i], candidates[*least]))) {
            least = i;
        }
    }
    return least;
}

} // namespace aolib
