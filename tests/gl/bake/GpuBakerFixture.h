#pragma once

#include <memory>
#include <utility>

#include "BakeScenes.h"
#include "GLTest.h"

namespace aolib::bake::test {

/// Bakers on the GPU.
class GpuBakerFixture : public GLTest {
protected:
    std::unique_ptr<AbstractBaker> scatter(BakeScene scene, const ScatterOptions& options) const {
        return made(createScatterBaker(loader, std::move(scene), options));
    }
    std::unique_ptr<AbstractBaker> shadow(BakeScene scene, const ShadowOptions& options) const {
        return made(createShadowBaker(loader, std::move(scene), options));
    }
    static BakedMap truthOf(const UvMesh& mesh, int size) {
        RayOptions options;
        options.rays = 1024;
        auto baker = createRayBaker(sceneOf(mesh), options);
        return onlyMap(**baker, size, 8, true);
    }
    /// A sphere in an open box.
    static UvMesh shapes() { return uvShape("uv-shapes"); }

private:
    static std::unique_ptr<AbstractBaker> made(Result<std::unique_ptr<AbstractBaker>> baker) {
        EXPECT_TRUE(baker.ok()) << baker.status().message();
        return std::move(*baker);
    }
};

} // namespace aolib::bake::test
