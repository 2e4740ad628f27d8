// Rows in clusters: a vertex mixes what the mean and the vectors of its cluster give under the light. Above: NUMBERS that a
// row gives; LIT_PART; and CLUSTER_ROWS with VECTORS, or MATRIX_CLUSTER_ROWS with MATRIX_VECTORS, or both.
//
// Number i of row r under the light: component i % 4 of texel t = (i / 4 / LIT_PART * rows + r) * LIT_PART + i / 4 %
// LIT_PART, in column t % 2048 of row t / 2048. Row r is the mean of cluster r / (1 + vectors) if the division leaves
// nothing, else its vector of the number that is left, from 1. RGBA32F, nearest; lit.vert writes it.
#ifdef CLUSTER_ROWS
layout(location = 6) in float cluster;
uniform sampler2D lit;
uniform sampler2D weights;  // the section of this name of relight.bin, as `transfer` and `rows` are
#endif
#ifdef MATRIX_CLUSTER_ROWS
layout(location = 7) in float matrix_cluster;
uniform sampler2D lit_matrices;    // the same, written by lit_matrices.vert
uniform sampler2D matrix_weights;
#endif

void add_mixed(sampler2D from, int rows, float cluster_of_vertex, sampler2D weights_of, int vectors,
               inout float sums[NUMBERS]) {
    int mean = int(cluster_of_vertex) * (1 + vectors);
    for (int k = 0; k <= vectors; ++k) {
        int w = gl_VertexID * vectors + k - 1;
        float weight = k == 0 ? 1.0 : texelFetch(weights_of, ivec2(w % 2048, w / 2048), 0).r;
        for (int four = 0; 4 * four < NUMBERS; ++four) {
            int t = (four / LIT_PART * rows + mean + k) * LIT_PART + four % LIT_PART;
            vec4 values = texelFetch(from, ivec2(t % 2048, t / 2048), 0);
            for (int i = 0; i < 4 && 4 * four + i < NUMBERS; ++i) sums[4 * four + i] += weight * values[i];
        }
    }
}
