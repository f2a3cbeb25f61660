// How large a pixel is in the map where the surface faces the light: a place of the map alone decides,
// not the direction of light, so that what charts cover can be summed with the same points.
uniform float uPixelSize; // side of a pixel across the light, frame units; 0: points stay as they are

// Points have a largest size; beyond it they stay too small.
const float kLargest = 48.0;

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
    return min(uPixelSize * sqrt(max(squares, 0.0)), kLargest);
}
