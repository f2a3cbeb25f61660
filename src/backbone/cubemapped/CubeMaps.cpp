#include "backbone/cubemapped/CubeMaps.h"

#include <algorithm>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "backbone/cubemapped/Placement.h"

namespace aolib {

namespace {

/// Texels of rays' detail along a texel.
constexpr int kDetailScale = 4;

bool contains(const std::vector<CubeMapProjector*>& list, const CubeMapProjector* one) {
    return std::find(list.begin(), list.end(), one) != list.end();
}

} // namespace

CubeMaps::CubeMaps(const BackboneContext& context, Removed removed)
    : context_(context), removed_(std::move(removed)), store_(context.gl), blocks_(store_) {}

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
    const int scale = context_.options.estimator == Estimator::RayTraced ? kDetailScale : 1;
    if (blocks_.scale() != scale) {
        for (const auto& projector : projectors_) {
            projector->dropBlocks(store_, blocks_);
        }
        blocks_.setScale(scale);
    }
    const int limit = Eviction::layersWithin(options, context_.gl.capabilities.maxTextureLayers);
    if (store_.faceSize() != options.faceSize || limit < store_.layers()) {
        for (const auto& projector : projectors_) {
            projector->dropBlocks(store_, blocks_);
            projector->dropFaces(store_);
            projector->tiles = TileProgress(options.faceSize);
            projector->dirty = true;
            projector->shown = false;
        }
        store_.reset(options.faceSize);
    }
    if (limit > store_.limit()) {
        allowBlocks();
    }
    store_.setLimit(limit);
    while (store_.spare() < 0) {
        evict(*Eviction::victim(projectors_, {}, Eviction::For::Budget));
    }
}

Result<CubeMapProjector*> CubeMaps::add(const glm::vec3& position, bool byHand) {
    auto projector = CubeMapProjector::create(context_.gl, CubeMapId{nextId_},
                                              Placement::freePosition(context_.scene, position),
                                              store_.faceSize());
    if (!projector) {
        return projector.status();
    }
    ++nextId_;
    store_.reserve();
    projectors_.push_back(std::make_unique<CubeMapProjector>(std::move(*projector)));
    projectors_.back()->use.byHand = byHand;
    return projectors_.back().get();
}

void CubeMaps::remove(CubeMapProjector& projector) {
    removed_(projector);
    projector.dropBlocks(store_, blocks_);
    projector.dropFaces(store_);
    store_.release();
    std::erase_if(projectors_, [&](const auto& one) { return one.get() == &projector; });
    allowBlocks(); // there may be room for it now
}

AoStatus CubeMaps::makeRoomAtOnce() {
    if (makeRoom(Eviction::For::Newcomer, {}, /*atOnce=*/true)) {
        return {};
    }
    return {StatusCode::OutOfMemory,
            "the " + std::to_string(projectors_.size()) +
                " cube maps placed by hand leave no room for another within "
                "Options::cubeMaps.memoryBudget or the texture layers of this context"};
}

bool CubeMaps::makeRoom(Eviction::For reason, const std::vector<CubeMapProjector*>& used,
                        bool atOnce) {
    while (store_.spare() < (reason == Eviction::For::Newcomer ? kFaces : 1)) {
        CubeMapProjector* victim = Eviction::victim(projectors_, used, reason);
        if (victim == nullptr) {
            return false;
        }
        if (!atOnce && victim->shown && contains(used, victim)) {
            victim->use.retiring = true;
            return false;
        }
        evict(*victim);
    }
    return true;
}

void CubeMaps::evictWhereDue(const std::vector<CubeMapProjector*>& used, bool atOnce) {
    std::vector<CubeMapProjector*> left;
    for (const auto& projector : projectors_) {
        const bool faded = projector->bias <= CubeMapProjector::kNewcomer;
        if (projector->use.retiring && (faded || atOnce || !contains(used, projector.get()))) {
            left.push_back(projector.get());
        }
    }
    for (CubeMapProjector* projector : left) {
        evict(*projector);
    }
    const bool refused = std::any_of(projectors_.begin(), projectors_.end(), [](const auto& one) {
        return one->use.surveysUnseen == 0 && one->tiles.refusedBlock();
    });
    if (refused) {
        std::vector<CubeMapProjector*> still = used;
        std::erase_if(still, [&](const auto* one) { return contains(left, one); });
        if (makeRoom(Eviction::For::Block, still, atOnce)) {
            allowBlocks();
        }
    }
}

void CubeMaps::evict(CubeMapProjector& projector) {
    ++evicted_;
    remove(projector);
}

void CubeMaps::allowBlocks() {
    for (const auto& projector : projectors_) {
        projector->tiles.allowBlocks();
    }
}

} // namespace aolib
