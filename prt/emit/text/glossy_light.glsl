
// The radiance that a row lets through, red, green, blue. Above: COUNT and, where the file has them, ROW and APPLY with
// SAMPLES, or ROW and PRODUCT.

// Coefficients of the light's radiance, red, green, blue, in the axes of the mesh.
uniform vec3 light[COUNT];
#ifdef APPLY
// What transfer_prepare makes of each channel of the light, one channel after the other.
uniform vec4 samples[(3 * SAMPLES + 3) / 4];
#endif
#ifdef ROW
// Number i of the section `rows` of relight.bin in column i % 2048 of row i / 2048. Nearest.
uniform sampler2D rows;
#endif
#ifdef MATRIX_CHANNELS
uniform sampler2D matrices;  // the same of the section `matrices`
#endif

void direct(int row, out float reaching[3 * COUNT]) {
    for (int i = 0; i < 3 * COUNT; ++i) reaching[i] = light[i % COUNT][i / COUNT];
#ifdef ROW
    float visibility[ROW];
    for (int k = 0; k < ROW; ++k) {
        int i = row * ROW + k;
        visibility[k] = texelFetch(rows, ivec2(i % 2048, i / 2048), 0).r;
#ifdef ROW_SCALE
        visibility[k] *= row_scale[k];
#endif
    }
#endif
#if defined(APPLY)
    float of_light[3 * SAMPLES];
    for (int i = 0; i < 3 * SAMPLES; ++i) of_light[i] = samples[i / 4][i % 4];
    APPLY(visibility, of_light, reaching);
#elif defined(PRODUCT)
    for (int c = 0; c < 3; ++c) {
        float of_light[COUNT];
        float product[COUNT];
        for (int i = 0; i < COUNT; ++i) of_light[i] = light[i][c];
        PRODUCT(visibility, of_light, product);
        for (int i = 0; i < COUNT; ++i) reaching[c * COUNT + i] = product[i];
    }
#endif
}

#ifdef MATRIX_CHANNELS
void add_indirect(int number, inout float reaching[3 * COUNT]) {
    float incident[3 * COUNT];
    for (int i = 0; i < 3 * COUNT; ++i) incident[i] = light[i % COUNT][i / COUNT];
    for (int row = 0; row < COUNT; ++row) {
        float entries[MATRIX_CHANNELS * COUNT];
        for (int c = 0; c < MATRIX_CHANNELS; ++c) {
            for (int k = 0; k < COUNT; ++k) {
                int i = ((number * MATRIX_CHANNELS + c) * COUNT + row) * COUNT + k;
                entries[c * COUNT + k] = texelFetch(matrices, ivec2(i % 2048, i / 2048), 0).r;
            }
        }
        float rgb[3];
        MATRIX_ROW(entries, incident, rgb);
        for (int c = 0; c < 3; ++c) reaching[c * COUNT + row] += rgb[c];
    }
}
#endif
