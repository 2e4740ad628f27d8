// Exit radiance of a glossy vertex towards the eye. Above: COUNT, BANDS, COSINE, ZONAL, GATHER and, where the file has
// them, ROW and APPLY with SAMPLES, or ROW and PRODUCT; MATRIX_CHANNELS and MATRIX_ROW.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 albedo;    // linear RGB
layout(location = 2) in vec3 normal;    // unit
layout(location = 3) in vec3 emitted;   // of the surfaces themselves; disabled without it, which reads 0
layout(location = 4) in vec3 specular;  // linear RGB reflectance of the lobe
layout(location = 5) in float exponent;

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
uniform vec3 eye;  // in the coordinates of the mesh
uniform mat4 to_clip;

out vec3 radiance;  // linear; ringing may make it slightly negative

// The radiance that reaches the vertex.
void transferred(out float reaching[3 * COUNT]) {
    for (int i = 0; i < 3 * COUNT; ++i) reaching[i] = light[i % COUNT][i / COUNT];
#ifdef ROW
    float visibility[ROW];
    for (int k = 0; k < ROW; ++k) {
        int i = gl_VertexID * ROW + k;
        visibility[k] = texelFetch(rows, ivec2(i % 2048, i / 2048), 0).r;
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
#ifdef MATRIX_CHANNELS
    float incident[3 * COUNT];
    for (int i = 0; i < 3 * COUNT; ++i) incident[i] = light[i % COUNT][i / COUNT];
    for (int row = 0; row < COUNT; ++row) {
        float entries[MATRIX_CHANNELS * COUNT];
        for (int c = 0; c < MATRIX_CHANNELS; ++c) {
            for (int k = 0; k < COUNT; ++k) {
                int i = ((gl_VertexID * MATRIX_CHANNELS + c) * COUNT + row) * COUNT + k;
                entries[c * COUNT + k] = texelFetch(matrices, ivec2(i % 2048, i / 2048), 0).r;
            }
        }
        float rgb[3];
        MATRIX_ROW(entries, incident, rgb);
        for (int c = 0; c < 3; ++c) reaching[c * COUNT + row] += rgb[c];
    }
#endif
}

// Band l of (e+1)/(2 pi) max(0, cos)^e: (e+1) times the integral of t^e P_l(t) over 0..1 [Hobson31].
float lobe_factor(int l, float e) {
    float factor = l % 2 == 0 ? 1.0 : (e + 1.0) / (e + 2.0);
    for (int k = 2 + l % 2; k <= l; k += 2) factor *= (e - float(k) + 2.0) / (e + float(k) + 1.0);
    return factor;
}

vec3 gathered(float zonal[BANDS], vec3 direction, float reaching[3 * COUNT]) {
    float lobe[COUNT];
    ZONAL(zonal, direction.x, direction.y, direction.z, lobe);
    float rgb[3];
    GATHER(lobe, reaching, rgb);
    return vec3(rgb[0], rgb[1], rgb[2]);
}

void main() {
    float reaching[3 * COUNT];
    transferred(reaching);
    float zonal[BANDS] = COSINE;
    radiance = emitted + albedo * gathered(zonal, normal, reaching);
    for (int l = 0; l < BANDS; ++l) zonal[l] = lobe_factor(l, exponent) * sqrt((2.0 * float(l) + 1.0) / 12.566371);
    vec3 to_eye = normalize(eye - position);
    radiance += specular * gathered(zonal, normalize(2.0 * dot(normal, to_eye) * normal - to_eye), reaching);
    gl_Position = to_clip * vec4(position, 1.0);
}
