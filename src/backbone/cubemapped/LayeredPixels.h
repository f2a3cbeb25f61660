#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "backbone/cubemapped/AbstractPixelSource.h"
#include "backbone/cubemapped/DeferredShading.h"

namespace aolib {

/// Computes every pixel from layered intervals that are captured about the eye, in more slices and
/// finer steps than a texel's: the view as a cube map of its own, in which what the view shows has
/// its pixels for texels. What is captured goes when the last pixel is done. Scenes of triangles,
/// and views of perspective cameras, of up to four million pixels; in others texels have to do.
class LayeredPixels final : public AbstractPixelSource {
public:
    /// What the sources of all views share.
    struct Shared {
        gl::GLSLShader visibility;
        gl::GLSLShader keep;
        FrameBudget budget;
    };
    /// Errors: ShaderError, OutOfMemory.
    static Result<Shared> createShared(const BackboneContext& context);
    /// All outlive it.
    LayeredPixels(Shared& shared, const SceneGeometry& geometry, DeferredShading& shading)
        : shared_(shared), geometry_(geometry), shading_(shading) {}

    void restart() override;
    void lookAgain() override {} // what other cube maps know is not asked
    /// Errors: NoScene, OutOfMemory, MissingCapability, ShaderError.
    AoStatus advance(const RestingView& view, FoundPixels& found, double milliseconds) override;
    bool done() const override { return stage_ == Stage::Done; }
    std::size_t bytes() const override;

private:
    enum class Stage { Begin, Capture, Targets, Tiles, Done };
    /// Everything that lasts until the view is done.
    struct Work {
        DeferredShading::Surroundings around;
        gl::RenderToTexture2D sums;    ///< blocked weight, weight
        std::vector<glm::ivec2> tiles; ///< lower left corners of those that are left, the next last
        int slices = 0;                ///< that the next one has had
    };

    WorkUnit next() const;
    /// Does units of the next kind, `most` at most. @return how many.
    Result<int> step(const RestingView& view, FoundPixels& found, int most);
    AoStatus begin(const RestingView& view);
    AoStatus makeTargets(const RestingView& view, FoundPixels& found);
    int computeTile(const RestingView& view, FoundPixels& found, int most);
    void accumulate(const RestingView& view, const glm::ivec2& tile, int first, int count);
    void keep(const RestingView& view, const FoundPixels& found, const glm::ivec2& tile);

    Shared& shared_;
    const SceneGeometry& geometry_;
    DeferredShading& shading_;
    Stage stage_ = Stage::Begin;
    std::optional<Work> work_;
};

} // namespace aolib
