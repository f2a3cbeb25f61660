#pragma once

#include <cstdint>
#include <optional>
#include <vector>

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

    /// With options of one's own, for pictures at rest.
    MeasuredHost(const gl::Functions& gl, ProcAddressLoader loader, const Model& model,
                 TracedKinds& truth, const Options& options);

    AmbientOcclusion& ao() { return *ao_; }

    /// W as the host's colours tell it, the same as readVisibility() tells it, and the truth of
    /// each of a pixel's samples, background -1.
    struct Samples {
        FloatImage shown;
        FloatImage read;
        std::vector<FloatImage> truth;
    };
    /// Draws frames until nothing is left to compute.
    Samples samples(const CameraKind& camera, const FramebufferKind& kind);

    /// RMSE of W, as the host's colours tell it.
    double error(const CameraKind& camera, const FramebufferKind& kind);

private:
    struct Target;

    MeasuredHost(const gl::Functions& gl, ProcAddressLoader loader, const Model& model,
                 TracedKinds& truth, View view, const Options& options);

    Target make(const FramebufferKind& kind) const;
    void frame(const CameraKind& camera, const FramebufferKind& kind, const HostTextures& textures);
    FloatImage expected(const CameraKind& camera, int samples);
    /// The truth of each sample of the framebuffer that is bound.
    std::vector<FloatImage> sampleTruth(const CameraKind& camera, int samples);
    /// The host's colours, their samples resolved.
    FloatImage resolvedColours(const CameraKind& camera, const FramebufferKind& kind,
                               const Target& target) const;
    FloatImage colours(const CameraKind& camera, const FramebufferKind& kind) const;

    const gl::Functions& gl_;
    ProcAddressLoader loader_;
    TracedKinds& truth_;
    const View view_;
    WhiteHost host_;
    std::optional<AmbientOcclusion> ao_;
};

} // namespace aolib::test
