#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "backbone/refine/AbstractPixelRefiner.h"
#include "backbone/texels/DeferredShading.h"

namespace aolib {

/// Computes every pixel from layered intervals that are captured about the eye, in more slices and
/// finer steps than a texel's: the view as a cube map of its own, in which what the view shows has
/// its pixels for texels. What is captured goes when the last pixel is done. Scenes of triangles,
/// and views of perspective cameras, of up to four million pixels; in others texels have to do.
class LayeredRefiner final : public AbstractPixelRefiner {
public:
    /// What the sources of all views share.
    struct Shared {
        gl::GLSLShader visibility;
        gl::GLSLShader keep;
    };
    /// Errors: ShaderError, OutOfMemory.
    static Result<Shared> createShared(const BackboneContext& context);
    /// All outlive it.
    LayeredRefiner(Shared& shared, const SceneGeometry& geometry, DeferredShading& shading)
        : shared_(shared), geometry_(geometry), shading_(shading) {}

    void restart() override;
    void invalidate() override {} // it depends on no cube map
    std::optional<WorkUnit> next() override;
    bool isReady() override;
    /// Errors: NoScene, OutOfMemory, MissingCapability, ShaderError.
    Result<int> step(const StaticView& view, RefinedPixels& pixels, int most) override;
    void await(const StaticView& view, double /*milliseconds*/) override {
        view.context.gl.Finish();
    }
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

    Result<int> stepStage(const StaticView& view, RefinedPixels& pixels, int most);
    AoStatus begin(const StaticView& view);
    AoStatus makeTargets(const StaticView& view, RefinedPixels& pixels);
    int computeTile(const StaticView& view, RefinedPixels& pixels, int most);
    void accumulate(const StaticView& view, const glm::ivec2& tile, int first, int count);
    void keep(const StaticView& view, const RefinedPixels& pixels, const glm::ivec2& tile);

    Shared& shared_;
    const SceneGeometry& geometry_;
    DeferredShading& shading_;
    Stage stage_ = Stage::Begin;
    std::optional<Work> work_;
};

} // namespace aolib
