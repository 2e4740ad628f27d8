
// A glossy vertex, and the radiance that reaches it. Above: COUNT, `direct` or clusters; LOBES, BRDFS if there are any.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 albedo;   // linear RGB
layout(location = 2) in vec3 normal;   // unit
layout(location = 3) in vec3 emitted;  // of the surfaces themselves; disabled without it, which reads 0
#ifdef LOBES
layout(location = 4) in vec3 specular;  // linear RGB reflectance of the lobe
layout(location = 5) in float exponent;
#else
const vec3 specular = vec3(0.0);
const float exponent = 0.0;
#endif
#ifdef BRDFS
layout(location = 8) in float brdf;  // brdfs.glsl
#else
const float brdf = 0.0;
#endif

uniform mat4 to_clip;

// The radiance that reaches the vertex.
void transferred(out float reaching[3 * COUNT]) {
#ifdef CLUSTER_ROWS
    for (int i = 0; i < 3 * COUNT; ++i) reaching[i] = 0.0;
    add_mixed(lit, CLUSTER_ROWS, cluster, weights, VECTORS, NUMBERS, LIT_PART, reaching);
#else
    direct(gl_VertexID, reaching);
#endif
#if defined(MATRIX_CLUSTER_ROWS)
    float more[NUMBERS];
    for (int i = 0; i < NUMBERS; ++i) more[i] = 0.0;
    add_mixed(lit_matrices, MATRIX_CLUSTER_ROWS, matrix_cluster, matrix_weights, MATRIX_VECTORS, 3 * MATRIX_ROWS,
              MATRIX_LIT_PART, more);
#elif defined(MATRIX_CHANNELS)
    float more[3 * MATRIX_ROWS];
    indirect(gl_VertexID, more);
#endif
#ifdef MATRIX_ROWS
    for (int i = 0; i < 3 * MATRIX_ROWS; ++i) reaching[i / MATRIX_ROWS * COUNT + i % MATRIX_ROWS] += more[i];
#endif
}
