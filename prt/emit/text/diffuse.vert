// Exit radiance of a vertex from its row. Above: COUNT, CHANNELS, KEPT_COUNT, KEPT(k), RELIGHT.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 albedo;   // linear RGB; read where the rows do not hold it
layout(location = 3) in vec3 emitted;  // of the surfaces themselves; disabled without it, which reads 0

// Number i of the section `rows` of relight.bin in column i % 2048 of row i / 2048. Nearest.
uniform sampler2D rows;
// Coefficient KEPT(k) of the light's radiance, red, green, blue, in the axes of the mesh, times entry k of
// `light_factors` of relight.json, if there are any.
uniform vec3 light[KEPT_COUNT];
uniform mat4 to_clip;

out vec3 radiance;  // linear; ringing may make it slightly negative

float stored(int i) { return texelFetch(rows, ivec2(i % 2048, i / 2048), 0).r; }

void main() {
    float transfer[CHANNELS * COUNT];
    float values[3 * COUNT];
    for (int k = 0; k < KEPT_COUNT; ++k) {
        for (int c = 0; c < CHANNELS; ++c) {
            transfer[c * COUNT + KEPT(k)] = stored((gl_VertexID * CHANNELS + c) * KEPT_COUNT + k);
        }
        for (int c = 0; c < 3; ++c) values[c * COUNT + KEPT(k)] = light[k][c];
    }
    float rgb[3];
    RELIGHT(transfer, values, rgb);
    radiance = vec3(rgb[0], rgb[1], rgb[2]);
#ifdef RECOLORABLE
    radiance *= albedo;
#endif
    radiance += emitted;
    gl_Position = to_clip * vec4(position, 1.0);
}
