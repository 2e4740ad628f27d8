
// Exit radiance of a glossy vertex towards the eye. Above: BANDS, COSINE, ZONAL, GATHER, and what reaches it.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 albedo;    // linear RGB
layout(location = 2) in vec3 normal;    // unit
layout(location = 3) in vec3 emitted;   // of the surfaces themselves; disabled without it, which reads 0
layout(location = 4) in vec3 specular;  // linear RGB reflectance of the lobe
layout(location = 5) in float exponent;

uniform vec3 eye;  // in the coordinates of the mesh
uniform mat4 to_clip;

out vec3 radiance;  // linear; ringing may make it slightly negative

// The radiance that reaches the vertex.
void transferred(out float reaching[3 * COUNT]) {
#ifdef CLUSTER_ROWS
    for (int i = 0; i < 3 * COUNT; ++i) reaching[i] = 0.0;
    add_mixed(lit, CLUSTER_ROWS, cluster, weights, VECTORS, reaching);
#else
    direct(gl_VertexID, reaching);
#endif
#if defined(MATRIX_CLUSTER_ROWS)
    add_mixed(lit_matrices, MATRIX_CLUSTER_ROWS, matrix_cluster, matrix_weights, MATRIX_VECTORS, reaching);
#elif defined(MATRIX_CHANNELS)
    add_indirect(gl_VertexID, reaching);
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
