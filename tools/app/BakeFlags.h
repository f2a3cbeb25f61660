#pragma once

#include <optional>
#include <string>
#include <vector>

#include <aolib/bake/BakeOptions.h>

#include "app/GlSession.h"
#include "app/ParseValues.h"

namespace CLI {
class App;
} // namespace CLI

namespace aolib::app {

enum class BakeMethod { Rays, Scatter, Shadow };
enum class BakeTarget { Texture, Vertex, Camera };
enum class Unwrap { Auto, Never, Always };
enum class VertexAttribute { Ao, Color };

/// What `aolib bake` is asked for.
struct BakeFlags {
    std::vector<std::string> inputs;
    std::string out;
    std::string ao;
    std::string bentNormals;
    std::string watch;    ///< picture of the map so far
    double seconds = 0.0; ///< after which the bake is ended; 0: never
    BakeMethod method = BakeMethod::Rays;
    BakeTarget target = BakeTarget::Texture;
    Unwrap unwrap = Unwrap::Auto;
    VertexAttribute attribute = VertexAttribute::Ao;
    int bits = 8;
    int uvSet = -1;               ///< -1: the first that will do
    std::string camera;           ///< by name; empty: the first
    int width = 960;              ///< of its picture, pixels
    int height = 540;             ///< pixels
    Length radius;                ///< 0: endless
    bake::RayOptions rays;        ///< its sky, falloff and seed are those of all methods
    bake::ScatterOptions scatter; ///< its directions are those of shadow maps, too
    bake::ShadowOptions shadow;
    bake::MapOptions map;
    bake::VertexOptions vertices;
    GlFlags gl;
    std::vector<float> poses; ///< times of the animation, seconds; none: the model at rest
    int animation = 0;
    bool ground = false;
    std::optional<double> groundHeight; ///< none: below the model

    /// Adds the flags to a command. The object must outlive it.
    void attach(CLI::App& command);
};

} // namespace aolib::app
