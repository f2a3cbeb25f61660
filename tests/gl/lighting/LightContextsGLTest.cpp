// An EnvironmentLight that ends in another context than that which it was created in.
#include <optional>
#include <utility>
#include <vector>

#include <aolib/lighting/EnvironmentLight.h>

#include "GLTest.h"
#include "TwinContext.h"

namespace aolib::lighting {
namespace {

class LightContextsGLTest : public ContextTest {
protected:
    void SetUp() override { open({ContextRequest::Api::Egl, ContextRequest::Profile::Core}); }
    EnvironmentLight make() const {
        const EnvironmentMap white{
            .width = 8, .height = 4, .radiance = std::vector<glm::vec3>(32, glm::vec3(1.0F))};
        return std::move(*EnvironmentLight::create(
            loader, white, {.cones = {.columns = 16, .rows = 9, .apertures = 3}}));
    }
    bool exists(TextureName name) const {
        return gl.IsTexture(static_cast<GLuint>(name)) == GL_TRUE;
    }
};

TEST_F(LightContextsGLTest, ItsTexturesGoInAContextThatSharesThem) {
    const TwinContext twin(loader);
    std::optional<EnvironmentLight> light(make());
    const TextureName cones = light->cones();
    twin.makeCurrent();
    EXPECT_TRUE(exists(cones));
    light.reset();
    EXPECT_FALSE(exists(cones));
    twin.makeFirstCurrent();
}

TEST_F(LightContextsGLTest, ElsewhereNothingIsTouched) {
    const TwinContext twin(loader, TwinContext::Shares::Nothing);
    std::optional<EnvironmentLight> light(make());
    const TextureName cones = light->cones();
    twin.makeCurrent();
    {
        const EnvironmentLight own = make(); // its names are the other's
        EXPECT_TRUE(exists(cones));
        light.reset();
        EXPECT_TRUE(exists(own.cones()) && exists(own.map()));
        light.emplace(make());
        twin.makeNoneCurrent();
        light.reset();
        twin.makeCurrent();
    }
    EXPECT_EQ(takeError(), static_cast<GLenum>(GL_NO_ERROR));
    twin.makeFirstCurrent();
}

} // namespace
} // namespace aolib::lighting
