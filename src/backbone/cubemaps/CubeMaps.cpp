#include "backbone/cubemaps/CubeMaps.h"

#include <algorithm>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "backbone/cubemaps/Placement.h"

namespace aolib {

namespace {

bool contains(const std::vector<CubeMapProjector*>& list, const CubeMapProjector* one) {
    return std::find(list.begin(), list.end(), one) != list.end();
}

} // namespace

CubeMaps::CubeMaps(const BackboneContext& context, Removed removed)
    : context_(context), removed_(std::move(removed)), atlas_(context.gl) {}

CubeMapProjector* CubeMaps::find(CubeMapId id) const {
    const auto found = std::find_if(projectors_.begin(), projectors_.end(),
                                    [&](const auto& one) { return one->id() == id; });
    return found != projectors_.end() ? found->get() : nullptr;
}

std::vector<CubeMapProjector*> CubeMaps::nearest(const glm::vec3& camera) const {
    std::vector<CubeMapProjector*> chosen;
    for (const auto& projector : projectors_) {
        chosen.push_back(projector.get());
    }
    std::stable_sort(chosen.begin(), chosen.end(), [&](const auto* a, const auto* b) {
        return glm::distance(a->position(), camera) < glm::distance(b->position(), camera);
    });
    const auto limit = static_cast<std::size_t>(context_.options.cubeMaps.nearest);
    chosen.resize(std::min(chosen.size(), limit));
    return chosen;
}

void CubeMaps::followOptions() {
    const CubeMapOptions& options = context_.options.cubeMaps;
    const PageKind pages = traitsOf(context_.options.estimator).pages;
    if (atlas_.pages.kind() != pages) {
        for (const auto& projector : projectors_) {
            projector->releasePages();
        }
        atlas_.pages.setKind(pages);
    }
    const int limit = Eviction::layersWithin(options, context_.gl.capabilities.maxTextureLayers);
    if (atlas_.faces.faceSize() != options.faceSize || limit < atlas_.faces.layers()) {
        for (const auto& projector : projectors_) {
            projector->resize(options.faceSize);
        }
        atlas_.faces.reset(options.faceSize);
    }
    if (limit > atlas_.faces.limit()) {
        clearDeniedPages();
    }
    atlas_.faces.setLimit(limit);
    while (atlas_.faces.freeLayers() < 0) {
        evict(*victim({}, EvictionReason::Budget));
    }
}

Result<CubeMapProjector*> CubeMaps::add(const glm::vec3& position, bool pinned) {
    auto projector =
        CubeMapProjector::create(context_.gl, atlas_, CubeMapId{nextId_},
                                 Placement::freePosition(context_.scene, position), pinned);
    if (!projector) {
        return projector.status();
    }
    ++nextId_;
    atlas_.faces.reserve();
    projectors_.push_back(std::make_unique<CubeMapProjector>(std::move(*projector)));
    return projectors_.back().get();
}

void CubeMaps::remove(CubeMapProjector& projector) {
    removed_(projector);
    projector.releasePages();
    projector.releaseFaces();
    atlas_.faces.unreserve();
    std::erase_if(projectors_, [&](const auto& one) { return one.get() == &projector; });
    clearDeniedPages(); // there may be room for them now
}

AoStatus CubeMaps::makeRoomAtOnce() {
    if (makeRoom(EvictionReason::NewCubeMap, {}, /*atOnce=*/true)) {
        return {};
    }
    return {StatusCode::OutOfMemory,
            "the " + std::to_string(projectors_.size()) +
                " cube maps placed by the host leave no room for another within "
                "Options::cubeMaps.memoryBudget or the texture layers of this context"};
}

bool CubeMaps::makeRoom(EvictionReason reason, const std::vector<CubeMapProjector*>& used,
                        bool atOnce) {
    while (atlas_.faces.freeLayers() < (reason == EvictionReason::NewCubeMap ? kFaces : 1)) {
        CubeMapProjector* one = victim(used, reason);
        if (one == nullptr) {
            return false;
        }
        if (!atOnce && one->isVisible() && contains(used, one)) {
            one->fadeOut();
            return false;
        }
        evict(*one);
    }
    return true;
}

void CubeMaps::evictWhereDue(const std::vector<CubeMapProjector*>& used, bool atOnce) {
    std::vector<CubeMapProjector*> left;
    for (const auto& projector : projectors_) {
        if (projector->state() == CubeMapProjector::State::FadingOut &&
            (projector->isFadedOut() || atOnce || !contains(used, projector.get()))) {
            left.push_back(projector.get());
        }
    }
    for (CubeMapProjector* projector : left) {
        evict(*projector);
    }
    const bool denied = std::any_of(projectors_.begin(), projectors_.end(), [](const auto& one) {
        return one->usage().feedbackUnseen == 0 && one->tiles().hasDeniedPages();
    });
    if (denied) {
        std::vector<CubeMapProjector*> still = used;
        std::erase_if(still, [&](const auto* one) { return contains(left, one); });
        if (makeRoom(EvictionReason::Page, still, atOnce)) {
            clearDeniedPages();
        }
    }
}

CubeMapProjector* CubeMaps::victim(const std::vector<CubeMapProjector*>& used,
                                   EvictionReason reason) const {
    std::vector<Eviction::Candidate> candidates;
    for (const auto& one : projectors_) {
        candidates.push_back({.pinned = one->isPinned(),
                              .fadingOut = one->state() == CubeMapProjector::State::FadingOut,
                              .inUse = contains(used, one.get()),
                              .usage = one->usage()});
    }
    const auto found = Eviction::victim(candidates, reason);
    return found ? projectors_[*found].get() : nullptr;
}

void CubeMaps::recordUsage(const std::map<CubeMapId, float>& best) {
    for (const auto& projector : projectors_) {
        const auto found = best.find(projector->id());
        projector->recordUsage(found != best.end() ? found->second : 0.0F);
    }
}

void CubeMaps::evict(CubeMapProjector& projector) {
    ++evicted_;
    remove(projector);
}

void CubeMaps::clearDeniedPages() {
    for (const auto& projector : projectors_) {
        projector->clearDeniedPages();
    }
}

} // namespace aolib
