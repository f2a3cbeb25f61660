#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "backbone/cubemapped/LayeredPixels.h"
#include "backbone/cubemapped/TracedPixels.h"

namespace aolib {

/// What computes the pixels of views at rest: which kind the options and the scene call for, and a
/// source of that kind for each view.
class PixelSources {
public:
    enum class Kind : std::uint8_t { None, Traced, Layered };

    /// @param geometry  outlives it.
    PixelSources(const BackboneContext& context, const SceneGeometry& geometry)
        : context_(context), geometry_(geometry) {}

    /// The kind that suits the options and the scene as they are.
    Kind wanted() const;
    /// Makes what the sources of a kind share. Errors: ShaderError, OutOfMemory.
    AoStatus choose(Kind kind);
    /// The kind in use.
    Kind kind() const { return kind_; }
    /// A source of the kind in use; null for none.
    /// @param queue    outlives it; null unless the kind is Traced.
    /// @param shading  outlives it; null unless the kind is Layered.
    /// @param slot     of the view, which none else has.
    std::unique_ptr<AbstractPixelSource> make(TracerQueue* queue, DeferredShading* shading,
                                              unsigned slot);
    void dropTracer();

private:
    const BackboneContext context_;
    const SceneGeometry& geometry_;
    std::unique_ptr<gl::GLSLShader> traced_;
    std::unique_ptr<LayeredPixels::Shared> layered_;
    Kind kind_ = Kind::None;
};

} // namespace aolib
