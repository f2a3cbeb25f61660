// Pixels of a view at rest that were traced themselves, where shaders define AO_REFINED.
#ifdef AO_REFINED
uniform sampler2DArray uRefined; // visibility, and the depth it was traced for; -1 where it was not
#endif

// Visibility of a pixel whose depth is `d`; negative where it was not traced.
float refinedVisibility(ivec2 pixel, float d) {
#ifdef AO_REFINED
    vec2 refined = texelFetch(uRefined, ivec3(pixel, 0), 0).rg;
    return refined.g == d ? refined.r : -1.0;
#else
    return -1.0;
#endif
}
