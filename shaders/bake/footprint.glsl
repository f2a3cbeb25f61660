// How large a pixel is in the map where the surface faces the light: a place of the map alone decides,
// not the direction of light, so that what charts cover can be summed with the same points.
uniform float uPixelSize; // side of a pixel across the light, frame units; 0: points stay as they are

// Points have a largest size; beyond it they stay too small.
const float kLargest = 128.0;
// Where a chart is stretched more than so many times one way, as at a sphere's poles, few pixels make up
// many texels: points are so many times longer that way, on the surface three pixels still.
const float kStretched = 2.0;
const float kLonger = 3.0;

// Sides of the box about the pixel, texels. The lengths of the gradients of u and v on the surface, which
// the derivatives of texel and position across the picture give by the metric of the latter.
vec2 footprint(vec3 dpdx, vec3 dpdy, vec2 dtdx, vec2 dtdy) {
    float xx = dot(dpdx, dpdx);
    float xy = dot(dpdx, dpdy);
    float yy = dot(dpdy, dpdy);
    float determinant = xx * yy - xy * xy;
    if (determinant <= 0.0) {
        return vec2(0.0);
    }
    vec2 squares = (yy * dtdx * dtdx - 2.0 * xy * dtdx * dtdy + xx * dtdy * dtdy) / determinant;
    vec2 sides = uPixelSize * sqrt(max(squares, 0.0));
    vec2 across = kStretched * max(sides.yx, 1.0);
    return min(mix(sides, kLonger * sides, greaterThan(sides, across)), kLargest);
}
