#pragma once

#include <cstdint>
#include <optional>

#include <aolib/aolib.h>

#include "TracedKinds.h"
#include "WhiteHost.h"

namespace aolib::test {

/// A host of any kind with aolib as its guest, and how far its picture is from the truth.
/// Context: the one current at its creation, for every call and its end.
class MeasuredHost {
public:
    /// Whether a picture is looked at while the camera moves, or once it rests and its pixels have
    /// been computed by themselves.
    enum class View : std::uint8_t { Moving, AtRest };

    /// @param gl, truth  must outlive it.
    MeasuredHost(const gl::Functions& gl, ProcAddressLoader loader, const Model& model,
                 TracedKinds& truth, View view = View::Moving);

    /// RMSE of W, as the host's colours tell it.
    double error(const CameraKind& camera, const FramebufferKind& kind);

private:
    struct Target;

    Target make(const FramebufferKind& kind) const;
    void frame(const CameraKind& camera, const FramebufferKind& kind, const HostTextures& textures);
    FloatImage expected(const CameraKind& camera, int samples);
    FloatImage colours(const CameraKind& camera, const FramebufferKind& kind) const;

    const gl::Functions& gl_;
    ProcAddressLoader loader_;
    TracedKinds& truth_;
    const View view_;
    WhiteHost host_;
    std::optional<AmbientOcclusion> ao_;
};

} // namespace aolib::test
