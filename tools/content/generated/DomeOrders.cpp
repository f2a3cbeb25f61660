/// Mouldings, balusters, entablatures and frames of the rotunda.
#include <algorithm>
#include <cmath>

#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/constants.hpp>

#include "content/generated/DomeParts.h"

namespace aolib::dome {
namespace {

constexpr float quarter = glm::half_pi<float>();

float share(int i, int count) {
    return static_cast<float>(i) / static_cast<float>(count);
}

} // namespace

Moulding& Moulding::step(float dx, float dy) {
    points_.push_back(points_.back() + glm::vec2(dx, dy));
    return *this;
}

Moulding& Moulding::to(float x, float y) {
    points_.emplace_back(x, y);
    return *this;
}

Moulding& Moulding::ovolo(float dx, float dy, int points) {
    const glm::vec2 start = points_.back();
    for (int i = 1; i <= points; ++i) {
        const float t = quarter * share(i, points);
        points_.push_back(start + glm::vec2(dx * std::sin(t), dy * (1.0F - std::cos(t))));
    }
    return *this;
}

Moulding& Moulding::cavetto(float dx, float dy, int points) {
    const glm::vec2 start = points_.back();
    for (int i = 1; i <= points; ++i) {
        const float t = quarter * share(i, points);
        points_.push_back(start + glm::vec2(dx * (1.0F - std::cos(t)), dy * std::sin(t)));
    }
    return *this;
}

Moulding& Moulding::cymaRecta(float dx, float dy, int points) {
    return cavetto(0.5F * dx, 0.5F * dy, points).ovolo(0.5F * dx, 0.5F * dy, points);
}

Moulding& Moulding::cymaReversa(float dx, float dy, int points) {
    return ovolo(0.5F * dx, 0.5F * dy, points).cavetto(0.5F * dx, 0.5F * dy, points);
}

Moulding& Moulding::torus(float dy, int points) {
    const glm::vec2 start = points_.back();
    for (int i = 1; i <= points; ++i) {
        const float t = glm::pi<float>() * share(i, points);
        points_.push_back(start + 0.5F * dy * glm::vec2(std::sin(t), 1.0F - std::cos(t)));
    }
    return *this;
}

void addBaluster(SolidBuilder& builder, float height) {
    const float h = height;
    Moulding profile(0.0F, 0.0F);
    profile.to(0.12F * h, 0.0F)
        .step(0.0F, 0.06F * h)
        .cavetto(-0.06F * h, 0.06F * h, 2)
        .torus(0.05F * h, 3)
        .ovolo(0.07F * h, 0.14F * h, 3)
        .cavetto(-0.09F * h, 0.34F * h, 4)
        .torus(0.05F * h, 3)
        .cavetto(0.05F * h, 0.1F * h, 2)
        .step(0.02F * h, 0.0F)
        .to(0.12F * h, h)
        .to(0.0F, h);
    builder.lathe(profile.outline(), 10);
}

void addUrn(SolidBuilder& builder, float height) {
    const float h = height;
    builder.box({-0.22F * h, 0.0F, -0.22F * h}, {0.22F * h, 0.14F * h, 0.22F * h});
    Moulding profile(0.0F, 0.13F * h);
    profile.to(0.18F * h, 0.13F * h)
        .cavetto(-0.12F * h, 0.12F * h, 4)
        .torus(0.05F * h, 4)
        .ovolo(0.2F * h, 0.2F * h, 5)
        .cavetto(-0.1F * h, 0.22F * h, 5)
        .step(0.07F * h, 0.05F * h)
        .step(0.0F, 0.04F * h)
        .ovolo(-0.17F * h, 0.12F * h, 4)
        .to(0.05F * h, 0.95F * h)
        .to(0.0F, h);
    builder.lathe(profile.outline(), 18);
}

Outline entablature(float radius, float inner, float y, float scale) {
    const float s = scale;
    Moulding profile(inner, y);
    profile.to(radius, y)
        .step(0.0F, 0.26F * s)
        .step(0.05F * s, 0.0F)
        .step(0.0F, 0.32F * s)
        .step(0.03F * s, 0.02F * s)
        .cymaReversa(0.08F * s, 0.1F * s)
        .step(0.0F, 0.06F * s)
        .to(radius + 0.01F * s, y + 0.78F * s)
        .step(0.0F, 0.6F * s) // the frieze
        .cymaReversa(0.1F * s, 0.12F * s)
        .step(0.0F, 0.2F * s) // behind the dentils
        .ovolo(0.14F * s, 0.12F * s)
        .step(0.34F * s, 0.02F * s) // the soffit of the corona
        .step(0.0F, 0.2F * s)
        .step(0.03F * s, 0.03F * s)
        .cymaRecta(0.2F * s, 0.24F * s)
        .step(0.0F, 0.07F * s)
        .to(inner, y + 2.42F * s);
    return profile.outline();
}

void addCorniceBlocks(SolidBuilder& builder, float radius, float y, float scale, int dentils,
                      int brackets) {
    const float s = scale;
    const float pitch = glm::two_pi<float>() * radius / static_cast<float>(dentils);
    for (int i = 0; i < dentils; ++i) {
        builder.setPlace(around(share(i, dentils), radius, y));
        builder.box({-0.3F * pitch, 1.51F * s, 0.0F}, {0.3F * pitch, 1.69F * s, 0.2F * s});
    }
    std::vector<SolidBuilder::Station> path;
    for (int i = 0; i <= 6; ++i) { // a scroll that hangs under the corona
        const float t = share(i, 6);
        path.push_back({{0.0F, 1.83F * s - 0.05F * s * std::cos(6.0F * t), (0.2F + 0.34F * t) * s},
                        {0.11F * s, 0.0F, 0.0F},
                        {0.0F, (0.1F - 0.04F * t) * s, 0.0F}});
    }
    for (int i = 0; i < brackets; ++i) {
        builder.setPlace(around(share(i, brackets), radius, y));
        builder.sweep(
            {{-0.5F, -0.6F}, {-0.25F, -0.8F}, {0.25F, -0.8F}, {0.5F, -0.6F}, {0.5F, 1}, {-0.5F, 1}},
            path, false);
    }
    builder.setPlace(glm::mat4(1.0F));
}

void addArchivolt(SolidBuilder& builder, const Frame& wall, const glm::vec2& low,
                  const glm::vec2& high, float width) {
    const float radius = 0.5F * (high.x - low.x);
    const glm::vec2 centre{low.x + radius, high.y - radius};
    const glm::vec3 normal = glm::cross(wall.u, wall.v);
    std::vector<SolidBuilder::Station> path;
    const auto add = [&](const glm::vec2& p, const glm::vec2& across) {
        path.push_back({wall.at(p), wall.u * across.x + wall.v * across.y, normal});
    };
    constexpr int segments = 18;
    add(low, {-1.0F, 0.0F});
    for (int i = 0; i <= segments; ++i) {
        const float angle = glm::pi<float>() * (1.0F - share(i, segments));
        const glm::vec2 radial{std::cos(angle), std::sin(angle)};
        add(centre + radius * radial, radial);
    }
    add({high.x, low.y}, {1.0F, 0.0F});
    const float w = width;
    Moulding profile(0.0F, -0.04F);
    profile.to(w, -0.04F)
        .step(0.0F, 0.04F + 0.38F * w)
        .step(-0.12F * w, 0.06F * w)
        .cavetto(-0.2F * w, -0.16F * w, 3)
        .step(-0.06F * w, 0.0F)
        .step(0.0F, -0.06F * w)
        .step(-0.24F * w, 0.0F)
        .ovolo(-0.06F * w, -0.06F * w, 2)
        .to(0.0F, 0.1F * w);
    builder.sweep(profile.outline(), path, false);
}

glm::mat4 around(float share, float radius, float y) {
    const glm::mat4 turned =
        glm::rotate(glm::mat4(1.0F), glm::two_pi<float>() * share, {0.0F, 1.0F, 0.0F});
    return glm::translate(turned, {0.0F, y, radius});
}

} // namespace aolib::dome
