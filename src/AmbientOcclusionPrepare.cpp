// Cube maps behind a loading screen.
#include <algorithm>
#include <exception>
#include <string>

#include "AmbientOcclusionImpl.h"

namespace aolib {

namespace {

/// Time between two calls of a progress callback.
constexpr double kMillisecondsPerProgress = 20.0;

} // namespace

AoStatus AmbientOcclusion::prepare(const ProgressCallback& callback,
                                   std::span<const glm::vec3> positions) {
    return impl_->report(impl_->prepare(callback, positions));
}

AoStatus AmbientOcclusion::Impl::prepare(const ProgressCallback& callback,
                                         std::span<const glm::vec3> positions) {
    if (drawing) {
        return {StatusCode::InvalidCallOrder, "prepare: a frame has begun; call aoDrawEnd first"};
    }
    if (!std::ranges::all_of(positions, [](const glm::vec3& one) { return isFinite(one); })) {
        return {StatusCode::InvalidPosition, "the position of a cube map must be finite"};
    }
    if (AoStatus status =
            withCubeMaps([&](BackboneCubemapped& to) { return to.beginPreparing(positions); });
        !status) {
        return status;
    }
    for (float progress = 0.0F; progress < 1.0F;) {
        const auto done = withCubeMaps(
            [](BackboneCubemapped& to) { return to.goOnPreparing(kMillisecondsPerProgress); });
        if (!done) {
            return done.status();
        }
        progress = *done;
        if (AoStatus status = report(callback, progress); !status) {
            return status;
        }
    }
    return {};
}

AoStatus AmbientOcclusion::Impl::report(const ProgressCallback& callback, float progress) {
    const Flag running(rendering);
    try {
        if (!callback || callback(progress)) {
            return {};
        }
    } catch (const std::exception& thrown) {
        return {StatusCode::CallbackFailed,
                std::string("the progress callback threw: ") + thrown.what()};
    } catch (...) {
        return {StatusCode::CallbackFailed,
                "the progress callback threw an exception that is not a std::exception"};
    }
    return {StatusCode::Cancelled, "prepare: the progress callback returned false; texels that "
                                   "were computed stay"};
}

} // namespace aolib
