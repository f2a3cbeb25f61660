#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include <aolib/RayTracing.h>

#include "Guest.h"
#include "RefusalTest.h"
#include "host/ModelScene.h"

namespace aolib {

/// An instance whose calls GL refuses one after the other: each ends in a clean status, the host's
/// state intact, nothing left behind, and the instance is as good as before once GL gives again.
class FaultTest : public RefusalTest {
protected:
    struct Step {
        const char* name;
        std::function<AoStatus(AmbientOcclusion&)> call;
    };
    /// What an instance holds at the end of its steps.
    struct Outcome {
        std::vector<float> visibility;
        std::vector<std::vector<float>> cubeMaps;
        bool operator==(const Outcome&) const = default;
    };

    void SetUp() override;
    void TearDown() override;

    Options options() const {
        Options small = smallOptions();
        small.estimator = estimator_;
        small.cubeMaps.coverage = 0.0F; // placed in an empty scene only: no matter of timing
        return small;
    }
    Result<AmbientOcclusion> make() {
        auto ao = AmbientOcclusion::create(faulty_->loader(), options());
        if (ao) {
            meshes_ = *host::describeScene(*ao, guestScene(), host::SceneNormals::Geometric);
            EXPECT_TRUE(ao->aoSetCamera(Guest::view(), Guest::projection()).ok());
            if (estimator_ == Estimator::RayTraced) {
                ao->setTexelTracer(std::move(*createTexelTracer(1)));
            }
        }
        return ao;
    }
    static AoStatus frame(AmbientOcclusion& ao) {
        (void)ao.aoDrawBegin();
        return ao.aoDrawEnd(Guest::eye().x, Guest::eye().y, Guest::eye().z);
    }

    /// Each call of each kind in turn, every stride-th alone, until there are no more.
    void refuseEachIn(const std::function<std::vector<Step>()>& steps,
                      std::initializer_list<Fault> faults, int stride);

    gl::Texture depth_;
    gl::Texture normal_;
    gl::Texture samples_; ///< depth, four samples per pixel
    std::vector<MeshId> meshes_;
    bool replaced_ = false;
    Estimator estimator_ = Estimator::HorizonSplit;

private:
    void reset(AmbientOcclusion& ao);
    std::optional<Outcome> run(const std::vector<Step>& steps, AmbientOcclusion& ao, Fault fault,
                               int n);
    gl::Texture texture(GLint internal, GLenum format, GLenum type);
    gl::Texture sampledDepth();

    int refusals_ = 0;
};

} // namespace aolib
