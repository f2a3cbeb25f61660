#pragma once

#include "RenderedScene.h"
#include "image/Metrics.h"
#include "reference/PictureTracer.h"

namespace aolib::test {

/// The ray-traced picture of a view, with the surfaces that it shows.
Picture traceView(const Model& model, const NamedCamera& camera, int width, int height,
                  float radius, int rays, NormalSource normals = NormalSource::Geometric);

/// W as a picture.
FloatImage visibilityOf(const Picture& picture);

/// W of the texels that a cube map holds where each pixel's surface lies: what projection and blur
/// start from. Background where the texel sees something else.
FloatImage texelsAt(const CubeMapImage& cubeMap, const Picture& picture);

/// The share of the reference's surface pixels that are surface in the test, too.
double shareOfSurface(const FloatImage& test, const FloatImage& reference);

/// RMSE over the pixels that are background in none of the pictures.
double rmse(const FloatImage& test, const FloatImage& reference);

} // namespace aolib::test
