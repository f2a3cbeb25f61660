// Pixels of a view at rest that were traced themselves, where shaders define AO_REPAIRED.
#ifdef AO_REPAIRED
uniform sampler2DArray uRepaired; // visibility, and the depth it was traced for; -1 where it was not
#endif

// Visibility of a pixel whose depth is `d`; negative where it was not traced.
float repairedVisibility(ivec2 pixel, float d) {
#ifdef AO_REPAIRED
    vec2 repaired = texelFetch(uRepaired, ivec3(pixel, 0), 0).rg;
    return repaired.g == d ? repaired.r : -1.0;
#else
    return -1.0;
#endif
}
