
// Radiance that a point of a medium sends to the eye. Its rows, row_sums above, give SH coefficients of the direction in which
// it is seen: ROWS of them, by the generated function BASIS. grid: points along x and y; cell: the distances between points.
uniform vec3 eye;  // in cells from the first point

out vec3 radiance;  // linear; ringing may make it slightly negative

void main() {
    ivec3 point = ivec3(gl_VertexID % grid.x, gl_VertexID / grid.x % grid.y, gl_VertexID / (grid.x * grid.y));
    vec3 seen = cell * (vec3(point) - eye);
    seen = length(seen) > 0.0 ? normalize(seen) : vec3(0.0, 0.0, 1.0);
    float basis[ROWS];
    BASIS(seen.x, seen.y, seen.z, basis);
    radiance = vec3(0.0);
    for (int r = 0; r < ROWS; ++r) radiance += basis[r] * row_sums(gl_VertexID * ROWS + r);
    gl_Position = vec4(0.0);
}
