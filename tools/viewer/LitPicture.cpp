#include "viewer/LitPicture.h"

#include <cmath>
#include <utility>

#include "image/ToneMap.h"

namespace aolib::viewer {

AoStatus LitPicture::prepare(const app::GlSession& session, const Light& light,
                             const glm::ivec2& pixels) {
    if (!renderer_ || drawn_.scene != light.scene) {
        renderer_.reset(); // its memory is needed
        drawn_ = {};
        Result<host::LitRenderer> made =
            host::LitRenderer::create(session.gl(), light.scene->pieces, {pixels.x, pixels.y});
        if (!made) {
            return made.status();
        }
        renderer_ = std::move(*made);
    }
    if (AoStatus status = renderer_->resize(pixels.x, pixels.y); !status) {
        return status;
    }
    if (drawn_.environment != light.environment || drawn_.turn != light.turn) {
        exposure_ = drawn_.environment == light.environment ? exposure_ : 0.0F;
        const lighting::EnvironmentMap map =
            lighting::turned(*light.environment, light.turn / 360.0F);
        if (AoStatus status = renderer_->setEnvironment(session.loader(), map); !status) {
            return status;
        }
    }
    drawn_ = light;
    return {};
}

AoStatus LitPicture::draw(const app::GlSession& session, const Light& light, const glm::mat4& view,
                          const glm::mat4& projection, const host::HostFramebuffer& target,
                          TracedPicture& painter) {
    const glm::ivec2 pixels(target.settings().width, target.settings().height);
    if (AoStatus status = prepare(session, light, pixels); !status) {
        return status;
    }
    renderer_->draw(view, projection, host::LitMethod::SectorsAndSun);
    const host::LitRenderer::Picture picture = renderer_->read();
    if (exposure_ == 0.0F) {
        const double mean = host::meanOverSurfaces(picture.radiance, picture.covered);
        exposure_ = mean > 0.0 ? static_cast<float>(1.0 / mean) : 0.0F;
    }
    const float exposure = exposure_ > 0.0F ? exposure_ : 1.0F;
    painter.upload(toneMapped(picture.radiance, exposure * std::exp2(light.stops)));
    target.bind();
    painter.show();
    return {};
}

} // namespace aolib::viewer
