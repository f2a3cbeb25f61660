#pragma once

#include <array>
#include <limits>
#include <string_view>

#include <aolib/Options.h>

namespace aolib {

/// The closed range of a number option.
struct OptionRange {
    double min;
    double max;
};

/// One choice of an enumeration option: its value, and its name on command lines.
template <typename E>
struct OptionChoice {
    E value;
    std::string_view name;
};

inline constexpr std::array kBackboneChoices{
    OptionChoice<Backbone>{Backbone::Cubemapped, "cubemapped"},
    OptionChoice<Backbone>{Backbone::ScreenSpace, "screenspace"}};
inline constexpr std::array kEstimatorChoices{
    OptionChoice<Estimator>{Estimator::HorizonSplit, "horizon-split"},
    OptionChoice<Estimator>{Estimator::LayeredIntervals, "layered-intervals"},
    OptionChoice<Estimator>{Estimator::RayTraced, "ray-traced"},
    OptionChoice<Estimator>{Estimator::Automatic, "automatic"}};
inline constexpr std::array kProjectionMethodChoices{
    OptionChoice<ProjectionMethod>{ProjectionMethod::SinglePass, "single-pass"},
    OptionChoice<ProjectionMethod>{ProjectionMethod::PingPong, "ping-pong"}};
inline constexpr std::array kFalloffChoices{OptionChoice<Falloff>{Falloff::Step, "step"},
                                            OptionChoice<Falloff>{Falloff::Exp, "exp"},
                                            OptionChoice<Falloff>{Falloff::Off, "none"}};
inline constexpr std::array kDebugViewChoices{
    OptionChoice<DebugView>{DebugView::Off, "none"},
    OptionChoice<DebugView>{DebugView::AmbientOcclusion, "ao"},
    OptionChoice<DebugView>{DebugView::Quality, "quality"},
    OptionChoice<DebugView>{DebugView::Faces, "faces"},
    OptionChoice<DebugView>{DebugView::Coverage, "coverage"},
    OptionChoice<DebugView>{DebugView::Edges, "edges"},
    OptionChoice<DebugView>{DebugView::Positions, "positions"},
    OptionChoice<DebugView>{DebugView::Normals, "normals"}};

/// Visits every option once, in the order of a help text. Checks, command lines and sliders are
/// generated from this list. The visitor takes
///   (name, number&, OptionRange, help)   for int and float,
///   (name, bool&, help)                  for switches,
///   (name, enum&, array of choices, help) for enumerations.
template <typename OptionsType, typename Visitor>
void visitOptions(OptionsType& o, Visitor&& visit) {
    constexpr double kMaxFloat = (std::numeric_limits<float>::max)(); // windows.h has a macro max
    visit("backbone", o.backbone, kBackboneChoices, "strategy that computes the occlusion");
    visit("estimator", o.estimator, kEstimatorChoices, "method that estimates visibility");
    visit("radius", o.radius, OptionRange{0.0, kMaxFloat},
          "reach of occluders, world units; 0 = 10% of the scene's diagonal");
    visit("falloff", o.falloff, kFalloffChoices, "weight of an occluder over its distance");
    visit("contrast", o.contrast, OptionRange{0.0, 1.0}, "strength of the darkening");
    visit("directions", o.horizonSplit.directions, OptionRange{1, 128},
          "horizon-split: directions about the normal");
    visit("steps", o.horizonSplit.steps, OptionRange{1, 256},
          "horizon-split: samples per direction");
    visit("step-size", o.horizonSplit.stepSize, OptionRange{0.0, kMaxFloat},
          "horizon-split, falloff step: world units between samples; 0 = radius / steps");
    visit("slices", o.layeredIntervals.slices, OptionRange{1, 128},
          "layered-intervals: slices of the hemisphere");
    visit("slice-steps", o.layeredIntervals.steps, OptionRange{1, 256},
          "layered-intervals: samples per slice and side");
    visit("layers", o.layeredIntervals.layers, OptionRange{1, 8},
          "layered-intervals: maximum number of solid intervals along a ray");
    visit("thickness", o.layeredIntervals.thickness, OptionRange{0.0, kMaxFloat},
          "layered-intervals where the host draws: assumed surface thickness, world units; 0 = "
          "radius / 4");
    visit("texel-rays", o.rayTraced.rays, OptionRange{4, 65536}, "ray-traced: rays per texel");
    visit("frame-budget", o.frameBudget, OptionRange{0.0, 1000.0},
          "milliseconds per frame for computing cube maps; 0 = each in one call");
    visit("face-size", o.cubeMaps.faceSize, OptionRange{16, 4096},
          "cube map: texels per face edge");
    visit("nearest", o.cubeMaps.nearest, OptionRange{1, 64}, "cube maps projected per frame");
    visit("place", o.cubeMaps.place, "place a cube map when a view's coverage is too low");
    visit("coverage", o.cubeMaps.coverage, OptionRange{0.0, 1.0},
          "share of shaded pixels below which a cube map is placed");
    visit("projection", o.cubeMaps.projection, kProjectionMethodChoices,
          "passes that project cube maps: one for all, or one each");
    visit("memory-budget", o.cubeMaps.memoryBudget, OptionRange{0.0, 1048576.0},
          "MiB of GPU memory for cube maps; 0 = no limit");
    visit("screen-space-fallback", o.cubeMaps.screenSpaceFallback,
          "use screen-space AO for pixels that no cube map covers");
    visit("refine-static-views", o.cubeMaps.refineStaticViews,
          "while a view is static, also compute its pixels: ray-traced, layered-intervals");
    visit("half-resolution", o.cubeMaps.halfResolution,
          "project onto a quarter of the pixels and upsample by depth");
    visit("outlines", o.cubeMaps.outlines, "draw a wire cube at each cube map");
    visit("blur", o.blur.enabled, "edge-aware blur of horizon-split and of screen-space AO");
    visit("blur-size", o.blur.size, OptionRange{1, 15}, "edge length of the blur, pixels, odd");
    visit("debug-view", o.debugView, kDebugViewChoices, "picture shown instead of the composite");
    visit("debug-groups", o.debugGroups, "group each pass's commands for debuggers");
    visit("trust-framebuffers", o.trust.framebuffers, "do not restore the framebuffer bindings");
    visit("trust-programs", o.trust.programs,
          "do not restore program, vertex array and array buffer");
    visit("trust-textures", o.trust.textures,
          "do not restore textures and samplers of units 0 to 7");
    visit("trust-pixels", o.trust.pixels, "do not restore pixel buffers, store and transfer");
    visit("trust-depth", o.trust.depth, "do not restore depth and stencil tests");
    visit("trust-blending", o.trust.blending, "do not restore blending and colour masks");
    visit("trust-raster", o.trust.raster, "do not restore culling, polygon, line and sample state");
    visit("trust-viewports", o.trust.viewports,
          "do not restore viewports, depth ranges and scissor tests");
}

} // namespace aolib
