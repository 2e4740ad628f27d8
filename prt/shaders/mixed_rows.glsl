
vec3 row_sums(int number) {
    float sums[NUMBERS] = float[NUMBERS](0.0, 0.0, 0.0);
    add_mixed(lit, CLUSTER_ROWS, cluster, weights, VECTORS, NUMBERS, LIT_PART, sums);
    return vec3(sums[0], sums[1], sums[2]);
}
