#include "app/BakeMethodFlags.h"

#include <CLI/CLI.hpp>

#include "app/BakeFlags.h"
#include "app/NumberFlags.h"

namespace aolib::app {

namespace {

void attachRays(BakeFlags& flags, CLI::App& command) {
    const char* const group = "Rays";
    addWholeNumber(
        command, "--rays", 1, 1 << 20, [&flags](int rays) { flags.rays.rays = rays; },
        "per texel, vertex or sample")
        ->default_str("256")
        ->group(group);
    addChoice<bake::Sampling>(
        command, "--sampling",
        {{"stratified", bake::Sampling::Stratified}, {"rejection", bake::Sampling::Rejection}},
        [&flags](bake::Sampling value) { flags.rays.sampling = value; },
        "Sobol's points about the normal, or random points in a cube")
        ->default_str("stratified")
        ->group(group);
    addChoice<bake::Measure>(
        command, "--measure",
        {{"cosine", bake::Measure::Cosine}, {"solid-angle", bake::Measure::SolidAngle}},
        [&flags](bake::Measure value) { flags.rays.measure = value; },
        "visibility W, or the plain share of open directions")
        ->default_str("cosine")
        ->group(group);
    addWholeNumber(
        command, "--threads", 0, 1024, [&flags](int threads) { flags.rays.threads = threads; },
        "0 = one per core")
        ->default_str("0")
        ->group(group);
}

void attachScatter(BakeFlags& flags, CLI::App& command) {
    const char* const group = "Scatter";
    bake::ScatterOptions& scatter = flags.scatter;
    addWholeNumber(
        command, "--raster", 0, 16384, [&scatter](int size) { scatter.rasterSize = size; },
        "pixels along the picture from each direction; 0 = by the map's texels")
        ->default_str("0")
        ->group(group);
    addNumber(
        command, "--point-size",
        [&scatter](double size) { scatter.pointSize = static_cast<float>(size); },
        "texels along a point's edge, with fractions; 0 = the nearest texel alone")
        ->default_str("0.5")
        ->group(group);
    command
        .add_flag("!--no-stretch", scatter.stretchCorrection,
                  "take charts to be stretched alike everywhere, for comparison")
        ->group(group);
    addChoice<bake::Normalisation>(
        command, "--normalise",
        {{"derived", bake::Normalisation::Derived}, {"brightest", bake::Normalisation::Brightest}},
        [&scatter](bake::Normalisation value) { scatter.normalisation = value; },
        "how sums become W: derived, or the brightest texel is taken for open")
        ->default_str("derived")
        ->group(group);
    addChoice<bake::SeamFix>(
        command, "--seams",
        {{"coverage", bake::SeamFix::Coverage}, {"erosion", bake::SeamFix::Erosion}},
        [&scatter](bake::SeamFix value) { scatter.seams = value; },
        "texels that charts cover in part: divided by that part, or discarded and filled")
        ->default_str("coverage")
        ->group(group);
}

void attachShadow(BakeFlags& flags, CLI::App& command) {
    const char* const group = "Shadow maps";
    bake::ShadowOptions& shadow = flags.shadow;
    addWholeNumber(
        command, "--depth-size", 64, 8192, [&shadow](int size) { shadow.depthSize = size; },
        "texels along a depth map")
        ->default_str("1024")
        ->group(group);
    addWholeNumber(
        command, "--maps-per-pass", 1, 16, [&shadow](int count) { shadow.mapsPerPass = count; },
        "depth maps read in one pass")
        ->default_str("8")
        ->group(group);
    addNumber(
        command, "--bias", [&shadow](double bias) { shadow.bias = static_cast<float>(bias); },
        "texels of a depth map by which receivers on slopes are lifted")
        ->default_str("1")
        ->group(group);
}

} // namespace

void attachBakeMethods(BakeFlags& flags, CLI::App& command) {
    attachRays(flags, command);
    attachScatter(flags, command);
    attachShadow(flags, command);
}

} // namespace aolib::app
