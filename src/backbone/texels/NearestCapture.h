#pragma once

#include "backbone/texels/AbstractCapture.h"
#include "backbone/texels/FaceCapture.h"
#include "gl/RenderToTexture2D.h"

namespace aolib {

/// The nearest surface of each texel: normal and distance. A unit is a face.
class NearestCapture final : public AbstractCapture {
public:
    /// @param shader  cubemap/capture.frag; outlives the capture.
    NearestCapture(const BackboneContext& context, const FaceCapture& faces, gl::GLSLShader& shader)
        : context_(context), faces_(faces), shader_(shader) {}

    bool complete() const override { return face_ == kFaces; }
    WorkUnit next() const override { return target_ ? WorkUnit::Draw : WorkUnit::Prepare; }
    AoStatus step() override;
    void bind(gl::GLSLShader& shader) const override;
    std::array<bool, kFaces> modelled() const override { return modelled_; }
    int layers() const override { return 1; }
    std::size_t bytes() const override { return target_ ? target_.bytes() : 0; }

private:
    AoStatus makeTarget();

    const BackboneContext context_;
    const FaceCapture faces_;
    gl::GLSLShader& shader_;
    gl::RenderToTexture2D target_; ///< six faces side by side
    int face_ = 0;                 ///< the next
    std::array<bool, kFaces> modelled_{};
};

} // namespace aolib
