#include "backbone/cubemapped/Eviction.h"

#include <algorithm>
#include <cmath>

namespace aolib {

namespace {

/// What a survey counts for in the running mean of usefulness: the last hundred make most of it.
/// Nobody having seen a cube map since, it falls on: the longest forgotten are missed least.
constexpr float kWeight = 1.0F / 64.0F;
/// Surveys for which a complete cube map stays in any case, so that two views that need more than
/// there is room for do not make each other's from frame to frame.
constexpr int kStay = 32;
/// Surveys in which a cube map was best nowhere until a block that is seen is worth more.
constexpr int kUnseen = 32;

constexpr double kMiB = 1024.0 * 1024.0;

bool mayGo(const CubeMapProjector& cubeMap, bool inUse, Eviction::For reason) {
    if (reason == Eviction::For::Budget) {
        return true;
    }
    const CubeMapProjector::Use& use = cubeMap.use;
    const bool settled = !inUse || use.retiring || use.surveysComplete >= kStay;
    const bool unseen = reason == Eviction::For::Newcomer || use.surveysUnseen >= kUnseen;
    return !use.byHand && settled && unseen;
}

/// Whether the first is missed less.
bool missedLess(const CubeMapProjector& a, const CubeMapProjector& b) {
    const CubeMapProjector::Use& one = a.use;
    const CubeMapProjector::Use& other = b.use;
    if (one.byHand != other.byHand) {
        return other.byHand;
    }
    if (one.retiring != other.retiring) {
        return one.retiring; // it goes already
    }
    return one.usefulness < other.usefulness;
}

} // namespace

int Eviction::layersWithin(const CubeMapOptions& options, int most) {
    if (options.memoryBudget <= 0.0F) {
        return most;
    }
    const double layers =
        std::floor(double{options.memoryBudget} * kMiB /
                   static_cast<double>(FaceStore::bytesPerLayer(options.faceSize)));
    return static_cast<int>(std::min(layers, static_cast<double>(most)));
}

void Eviction::follow(std::span<const std::unique_ptr<CubeMapProjector>> cubeMaps,
                      const std::map<CubeMapId, float>& best) {
    for (const auto& cubeMap : cubeMaps) {
        const auto found = best.find(cubeMap->id());
        const float share = found != best.end() ? found->second : 0.0F;
        CubeMapProjector::Use& use = cubeMap->use;
        use.usefulness += kWeight * (share - use.usefulness);
        use.surveysUnseen = share > 0.0F ? 0 : use.surveysUnseen + 1;
        use.surveysComplete += cubeMap->bias >= 0.0F ? 1 : 0;
    }
}

CubeMapProjector* Eviction::victim(std::span<const std::unique_ptr<CubeMapProjector>> cubeMaps,
                                   const std::vector<CubeMapProjector*>& used, For reason) {
    CubeMapProjector* least = nullptr;
    for (const auto& cubeMap : cubeMaps) {
        const bool inUse = std::find(used.begin(), used.end(), cubeMap.get()) != used.end();
        if (mayGo(*cubeMap, inUse, reason) && (least == nullptr || missedLess(*cubeMap, *least))) {
            least = cubeMap.get();
        }
    }
    return least;
}

} // namespace aolib
