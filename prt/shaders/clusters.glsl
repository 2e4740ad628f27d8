// Rows in clusters: a vertex mixes what the mean and the vectors of its cluster give under the light. Above: NUMBERS,
// the most that a row gives; CLUSTER_ROWS with VECTORS and LIT_PART, or MATRIX_CLUSTER_ROWS with MATRIX_VECTORS,
// MATRIX_ROWS and MATRIX_LIT_PART, or both.
//
// Number i of row r under the light: component i % 4 of texel t = (i / 4 / part * rows + r) * part + i / 4 % part, part
// the LIT_PART of the rows, in column t % 2048 of row t / 2048. Row r is the mean of cluster r / (1 + vectors) if the
// division leaves nothing, else its vector of the number that is left, from 1. RGBA32F, nearest; lit.vert writes it.
#ifdef CLUSTER_ROWS
layout(location = 6) in float cluster;
uniform sampler2D lit;
uniform sampler2D weights;  // of the vectors (numbers.glsl)
#endif
#ifdef MATRIX_CLUSTER_ROWS
layout(location = 7) in float matrix_cluster;
uniform sampler2D lit_matrices;    // the same, written by lit_matrices.vert
uniform sampler2D matrix_weights;
#endif

void add_mixed(sampler2D from, int rows, float cluster_of_vertex, sampler2D weights_of, int vectors, int numbers,
               int part, inout float sums[NUMBERS]) {
    int mean = int(cluster_of_vertex) * (1 + vectors);
    for (int k = 0; k <= vectors; ++k) {
        int w = gl_VertexID * vectors + k - 1;
        float weight = k == 0 ? 1.0 : number_at(weights_of, w);
        for (int four = 0; 4 * four < numbers; ++four) {
            int t = (four / part * rows + mean + k) * part + four % part;
            vec4 values = texelFetch(from, ivec2(t % 2048, t / 2048), 0);
            for (int i = 0; i < 4 && 4 * four + i < numbers; ++i) sums[4 * four + i] += weight * values[i];
        }
    }
}
