#pragma once

#include <vector>

#include "content/generated/SolidBuilder.h"

/// The parts of the generated rotunda. One unit is one metre, y is up, the axis is x = z = 0.
namespace aolib::dome {

/// Draws the outline of a moulding point by point, in (radius or projection, height).
class Moulding {
public:
    Moulding(float x, float y) : points_{{x, y}} {}

    Moulding& step(float dx, float dy);
    /// A quarter of an ellipse: convex (ovolo) or hollow (cavetto).
    Moulding& ovolo(float dx, float dy, int points = 6);
    Moulding& cavetto(float dx, float dy, int points = 6);
    /// Hollow below and convex above, or the other way round.
    Moulding& cymaRecta(float dx, float dy, int points = 4);
    Moulding& cymaReversa(float dx, float dy, int points = 4);
    /// A half round that sticks out by half its height.
    Moulding& torus(float dy, int points = 8);
    Moulding& to(float x, float y);
    const Outline& outline() const { return points_; }

private:
    std::vector<glm::vec2> points_;
};

/// How finely a column is made, as counts.
struct ColumnDetail {
    int perFlute;     ///< points across a flute
    int shaftRows;    ///< along the shaft
    int baseSegments; ///< around the base
    int bellSegments; ///< around the capital's bell
    int leafStations;
    int voluteStations;
};
/// A column of a given height and lower radius, standing on y = 0 of the builder's place.
void addFlutedColumn(SolidBuilder& builder, float height, float radius, const ColumnDetail& detail);
void addPlainColumn(SolidBuilder& builder, float height, float radius);
void addBaluster(SolidBuilder& builder, float height);
void addUrn(SolidBuilder& builder, float height);

/// The closed outline of an entablature ring: architrave, frieze and cornice of height 2.4 times
/// `scale` above y, its frieze at `radius`, its inner side at `inner`.
Outline entablature(float radius, float inner, float y, float scale);
/// Dentils and brackets under the cornice of such an entablature.
void addCorniceBlocks(SolidBuilder& builder, float radius, float y, float scale, int dentils,
                      int brackets);
/// A moulded frame about a round-arched opening of a wall, in the wall's frame.
void addArchivolt(SolidBuilder& builder, const Frame& wall, const glm::vec2& low,
                  const glm::vec2& high, float width);

void addLantern(std::vector<ModelMesh>& meshes, float y);
/// The vault: outer shell with ribs, inner shell with coffers. Springs at y.
void addVault(std::vector<ModelMesh>& meshes, float y);

/// The builder's place turned by a share of the full circle, `radius` away from the axis; local +z
/// looks outwards.
glm::mat4 around(float share, float radius, float y);

} // namespace aolib::dome
