#include "app/UnusedOptions.h"

#include <iostream>
#include <utility>

#include <CLI/CLI.hpp>
#include <aolib/OptionFields.h>

namespace aolib::app {

namespace {

/// Flags that something alone reads, and whether that is at work.
struct Readers {
    std::vector<const char*> flags;
    bool atWork;
    std::string who;
};

std::string sentence(const std::string& flag, const std::string& who) {
    return "--" + flag + " has no effect: only " + who + " reads it";
}

std::string nameOf(Estimator estimator) {
    for (const auto& choice : kEstimatorChoices) {
        if (choice.value == estimator) {
            return std::string(choice.name);
        }
    }
    return "unknown";
}

std::vector<Readers> readersOf(const Options& o) {
    const bool cubemapped = o.backbone == Backbone::Cubemapped;
    const bool horizon = o.estimator == Estimator::HorizonSplit;
    const bool layered = o.estimator == Estimator::LayeredIntervals;
    const bool traced = o.estimator == Estimator::RayTraced;
    return {
        {{"directions", "steps"}, horizon, "estimator horizon-split"},
        {{"step-size"},
         horizon && o.falloff == Falloff::Step,
         "estimator horizon-split with falloff step"},
        {{"slices", "slice-steps"}, layered, "estimator layered-intervals"},
        {{"layers"}, layered && cubemapped, "estimator layered-intervals with backbone cubemapped"},
        {{"thickness"},
         (layered && !cubemapped) || (cubemapped && o.cubeMaps.screenSpaceFallback),
         "estimator layered-intervals in screen space, or the fallback of cube maps,"},
        {{"texel-rays"},
         cubemapped && (traced || (layered && o.cubeMaps.refineStaticViews)),
         "estimator ray-traced, or the repair of layered-intervals,"},
        {{"frame-budget", "face-size", "nearest", "place", "projection", "memory-budget",
          "screen-space-fallback", "half-resolution", "outlines"},
         cubemapped,
         "backbone cubemapped"},
        {{"coverage"}, cubemapped && o.cubeMaps.place, "backbone cubemapped that places cube maps"},
        {{"refine-static-views"},
         cubemapped && !horizon,
         "backbone cubemapped with ray-traced or layered-intervals"},
        {{"blur"}, horizon || !cubemapped, "estimator horizon-split or backbone screenspace"},
        {{"blur-size"},
         (horizon || !cubemapped) && o.blur.enabled,
         "the blur of horizon-split or of screen space"}};
}

std::vector<Readers> readersOf(const CLI::App& command, const BakeFlags& flags) {
    const bool rays = flags.method == BakeMethod::Rays;
    const bool scatter = flags.method == BakeMethod::Scatter;
    const bool texture = flags.target == BakeTarget::Texture;
    const bool vertex = flags.target == BakeTarget::Vertex;
    const bool camera = flags.target == BakeTarget::Camera;
    const bool fitted = vertex && flags.vertices.fit == bake::VertexFit::LeastSquares;
    return {
        {{"rays", "sampling", "measure", "threads"}, rays, "method rays"},
        {{"directions"}, !rays, "method scatter or shadow"},
        {{"raster", "point-size", "no-stretch", "normalise", "seams"}, scatter, "method scatter"},
        {{"depth-size", "maps-per-pass", "bias"},
         flags.method == BakeMethod::Shadow,
         "method shadow"},
        {{"size", "padding", "no-fill", "uv-set", "unwrap"}, texture, "target texture"},
        {{"texel-samples"}, texture && !scatter, "target texture with method rays or shadow"},
        {{"bits"}, !vertex, "target texture or camera"},
        {{"fit", "attribute"}, vertex, "target vertex"},
        {{"smoothness", "density"}, fitted, "target vertex with fit least-squares"},
        {{"camera", "width", "height"}, camera, "target camera"},
        {{"animation"}, command.count("--poses") > 0, "a bake with --poses"},
        {{"falloff"}, flags.radius.value > 0.0, "a bake with --radius above 0"}};
}

} // namespace

std::vector<std::string> unusedOptions(const OptionFlags& given, const Options& options) {
    std::vector<std::string> sentences;
    for (const Readers& readers : readersOf(options)) {
        for (const char* flag : readers.flags) {
            if (given.given(flag) && !readers.atWork) {
                const std::string space =
                    options.backbone == Backbone::ScreenSpace ? " in screen space" : "";
                sentences.push_back(sentence(flag, readers.who) + "; this is " +
                                    nameOf(options.estimator) + space);
            }
        }
    }
    return sentences;
}

std::vector<std::string> unusedBakeFlags(const CLI::App& command, const BakeFlags& flags) {
    std::vector<std::string> sentences;
    for (const Readers& readers : readersOf(command, flags)) {
        for (const char* flag : readers.flags) {
            if (command.count("--" + std::string(flag)) > 0 && !readers.atWork) {
                sentences.push_back(sentence(flag, readers.who));
            }
        }
    }
    return sentences;
}

void warnOf(const std::vector<std::string>& sentences) {
    for (const std::string& text : sentences) {
        std::cerr << "warning: " << text << '\n';
    }
}

} // namespace aolib::app
