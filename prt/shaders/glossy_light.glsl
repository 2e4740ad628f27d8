
// The radiance that a row lets through, red, green, blue. Above: COUNT and, where the file has them, ROW, KEPT_COUNT,
// KEPT and APPLY with SAMPLES or PRODUCT; MATRIX_CHANNELS, MATRIX_ROWS, MATRIX_COLUMNS and MATRIX_ROW.

// Coefficients of the light's radiance, red, green, blue, in the axes of the mesh.
uniform vec3 light[COUNT];
#ifdef APPLY
// What transfer_prepare makes of each channel of the light, one channel after the other.
uniform vec4 samples[(3 * SAMPLES + 3) / 4];
#endif
#ifdef ROW
uniform sampler2D rows;  // numbers of visibility (numbers.glsl)
#endif
#ifdef MATRIX_CHANNELS
uniform sampler2D matrices;  // the same of the section `matrices`
#endif

void direct(int row, out float reaching[3 * COUNT]) {
    for (int i = 0; i < 3 * COUNT; ++i) reaching[i] = light[i % COUNT][i / COUNT];
#ifdef ROW
    float visibility[ROW];
    for (int k = 0; k < ROW; ++k) visibility[k] = 0.0;
    for (int k = 0; k < KEPT_COUNT; ++k) {
        visibility[KEPT(k)] = number_at(rows, row * KEPT_COUNT + k);
#ifdef ROW_SCALE
        visibility[KEPT(k)] *= row_scale[k];
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
void indirect(int number, out float sent[3 * MATRIX_ROWS]) {
    float incident[3 * MATRIX_COLUMNS];
    for (int i = 0; i < 3 * MATRIX_COLUMNS; ++i) incident[i] = light[i % MATRIX_COLUMNS][i / MATRIX_COLUMNS];
    for (int row = 0; row < MATRIX_ROWS; ++row) {
        float entries[MATRIX_CHANNELS * MATRIX_COLUMNS];
        for (int c = 0; c < MATRIX_CHANNELS; ++c) {
            for (int k = 0; k < MATRIX_COLUMNS; ++k) {
                int i = ((number * MATRIX_CHANNELS + c) * MATRIX_ROWS + row) * MATRIX_COLUMNS + k;
                entries[c * MATRIX_COLUMNS + k] = number_at(matrices, i);
            }
        }
        float rgb[3];
        MATRIX_ROW(entries, incident, rgb);
        for (int c = 0; c < 3; ++c) sent[c * MATRIX_ROWS + row] = rgb[c];
    }
}
#endif
