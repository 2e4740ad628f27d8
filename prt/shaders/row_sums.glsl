// What a baked row gives under the light. Below numbers.glsl, with
//   COUNT          coefficients of a channel, (degree+1)^2
//   CHANNELS       that the texture has: 1 (serves all colors) or 3
//   KEPT_COUNT     coefficients that the texture keeps; KEPT(k): the index of number k
//   RELIGHT        the generated function relight_l<degree> (WHITE and one channel), relight_rgb_l<degree> (one channel)
//                  or relight_colored_l<degree>, which stands above
//   ROW_OF(n, c)   the row of channel c among those of the texture, unless the channels of row n follow each other
//   WHITE          defined: a light with one channel for all colors
// defined; `prt shader` and `prt emit` write it all.

// The section `transfer` unchanged (numbers.glsl).
uniform sampler2D transfer;
// Coefficients KEPT(k) of the light's radiance in the object's own axes: turned by the inverse of its rotation, once an
// object; times entry k of `light_factors` where `prt emit` writes them.
#ifdef WHITE
uniform float light[KEPT_COUNT];
#else
uniform vec3 light[KEPT_COUNT];  // red, green, blue
#endif

#ifndef ROW_OF
#define ROW_OF(n, c) ((n) * CHANNELS + (c))
#endif

vec3 row_sums(int number) {
    float row[CHANNELS * COUNT];
    float values[3 * COUNT];
    for (int k = 0; k < KEPT_COUNT; ++k) {
        vec3 incident = vec3(light[k]);
        for (int c = 0; c < CHANNELS; ++c) {
            row[c * COUNT + KEPT(k)] = number_at(transfer, ROW_OF(number, c) * KEPT_COUNT + k);
        }
        for (int c = 0; c < 3; ++c) values[c * COUNT + KEPT(k)] = incident[c];
    }
#if defined(WHITE) && CHANNELS == 1
    float white[COUNT];
    for (int i = 0; i < COUNT; ++i) white[i] = values[i];
    return vec3(RELIGHT(row, white));
#else
    float rgb[3];
    RELIGHT(row, values, rgb);
    return vec3(rgb[0], rgb[1], rgb[2]);
#endif
}
