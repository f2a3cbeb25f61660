#include "backbone/BuildSchedule.h"

#include <algorithm>
#include <chrono>

namespace aolib {

namespace {

double millisecondsFrom(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

} // namespace

AoStatus BuildSchedule::chooseSource() {
    AoStatus status = sources_.choose();
    if (status) {
        passes_ = source().passes();
    }
    return status;
}

void BuildSchedule::sceneChanged(const std::vector<std::unique_ptr<CubeMapProjector>>& projectors,
                                 const std::vector<Scene::Change>& changes, float reach) {
    sources_.sceneChanged();
    for (const auto& projector : projectors) {
        for (const Scene::Change& change : changes) {
            if (sources_.source() != nullptr && !projector->mustBegin()) {
                source().sceneChanged(*projector, change, reach);
            }
        }
    }
}

bool BuildSchedule::isDue(const CubeMapProjector& projector) const {
    return projector.mustBegin() ||
           (projector.tiles().hasOutdated() && (atOnce() || source().mayRestart(projector)));
}

AoStatus BuildSchedule::compute(const std::vector<CubeMapProjector*>& projectors,
                                FrameBudget& budget) {
    if (AoStatus status = chooseSource(); !status) {
        return status;
    }
    for (CubeMapProjector* projector : projectors) {
        const bool begins = isDue(*projector);
        if (begins) {
            begin(*projector);
        }
        if (atOnce() && (begins || source().hasPending(*projector))) {
            projector->requestAll();
            if (AoStatus status = complete(*projector); !status) {
                projector->invalidate(); // some of it may be lost
                return status;
            }
        }
    }
    const AoStatus status =
        atOnce() ? AoStatus()
                 : advance(projectors, budget, static_cast<double>(context_.options.frameBudget));
    for (CubeMapProjector* projector : projectors) {
        if (atOnce()) {
            projector->endFade();
        } else {
            projector->stepFade(passes_);
        }
    }
    return status;
}

void BuildSchedule::begin(CubeMapProjector& projector) {
    if (projector.mustBegin()) {
        sources_.forget(projector.id());
        projector.releasePages();
        projector.setAllOutdated();
    }
    source().restart(projector);
    projector.begin();
    projector.resetBuildTime();
    ++begun_;
}

AoStatus BuildSchedule::complete(CubeMapProjector& projector) {
    const auto start = std::chrono::steady_clock::now();
    AoStatus status = source().complete(projector);
    projector.addBuildTime(millisecondsFrom(start));
    return status;
}

Result<bool> BuildSchedule::completeSome(const std::vector<CubeMapProjector*>& projectors,
                                         FrameBudget& budget, double milliseconds) {
    if (AoStatus status = chooseSource(); !status) {
        return status;
    }
    for (CubeMapProjector* projector : projectors) {
        if (projector->mustBegin() ||
            (projector->tiles().hasOutdated() && source().mayRestart(*projector))) {
            begin(*projector);
        }
        projector->requestAll();
    }
    if (AoStatus status = advance(projectors, budget, milliseconds); !status) {
        return status;
    }
    bool complete = true;
    for (CubeMapProjector* projector : projectors) {
        const bool pending = !projector->isVisible() || projector->tiles().hasOutdated() ||
                             source().hasPending(*projector);
        if (!pending) {
            projector->endFade();
        }
        complete = complete && !pending;
    }
    if (!complete) {
        source().await(milliseconds);
    }
    return complete;
}

AoStatus BuildSchedule::advance(const std::vector<CubeMapProjector*>& projectors,
                                FrameBudget& budget, double milliseconds) {
    const auto pending = std::ranges::find_if(
        projectors, [&](const auto* one) { return source().hasPending(*one); });
    const auto start = std::chrono::steady_clock::now();
    budget.beginFrame(milliseconds);
    source().beginFrame(projectors);
    const auto ended = runWithinBudget(budget, source());
    AoStatus status = ended ? source().endFrame() : ended.status();
    if (pending != projectors.end()) { // the one that is worked on
        (*pending)->addBuildTime(millisecondsFrom(start));
    }
    return status;
}

bool BuildSchedule::finished(const CubeMapProjector& projector, const TileSet& requested) const {
    // One that no feedback has requested tiles of has not begun.
    if (!projector.isVisible() || projector.tiles().hasOutdated() || projector.fade() < 0.0F) {
        return false;
    }
    return !source().hasPending(projector) ||
           (source().areFinal(projector) && !projector.tiles().hasPendingIn(requested, passes_));
}

} // namespace aolib
