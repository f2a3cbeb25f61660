#pragma once

#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "content/Model.h"
#include "content/generated/Pcg.h"
#include "content/generated/SolidBuilder.h"

/// The parts of the generated town. One unit is one metre, y is up, +z is south.
namespace aolib::town {

/// Height of the pavements above the streets.
constexpr float pavement = 0.14F;

/// A wall of a house-shaped body.
enum class Side { Front, Right, Back, Left };

/// A body with a gable roof: the ridge runs along x, the front faces +z.
struct GableBody {
    float length; ///< along x
    float width;  ///< along z
    float bottom;
    float eaves;
    float ridge;

    /// The frame of a wall: u to the right seen from outside, 0 at its middle; v is the height.
    Frame wall(Side side) const;
};

/// Adds the closed body; `openings` in the order of Side.
void addGableBody(SolidBuilder& builder, const GableBody& body,
                  const std::vector<std::vector<Opening>>& openings);
/// Adds a folded roof slab over the body.
void addGableRoof(SolidBuilder& builder, const GableBody& body, float overhang, float thickness);
/// Adds a sheet a little in front of the back of each recess: glass and doors.
void addPanes(SolidBuilder& builder, const Frame& frame, const std::vector<Opening>& openings);

/// A plot along a street: the house's front stands at its middle and faces +z of `place`.
struct Plot {
    glm::mat4 place;
    float width;
    float depth;
};
void addHouse(std::vector<ModelMesh>& meshes, const Plot& plot, int number, Pcg& random);

/// The church at the north of the square, with its tower and steps.
void addChurch(std::vector<ModelMesh>& meshes);
/// The town hall at the east of the square, over an open arcade.
void addTownHall(std::vector<ModelMesh>& meshes);
/// Fountain, market stalls and benches.
void addSquare(std::vector<ModelMesh>& meshes);
/// The wall about the town, its towers and its gate.
void addCityWall(std::vector<ModelMesh>& meshes);
void addTree(SolidBuilder& trunks, SolidBuilder& crowns, const glm::vec2& at, bool slender,
             Pcg& random);

} // namespace aolib::town
