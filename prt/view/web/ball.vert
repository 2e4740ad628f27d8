// Below light.glsl, whose function it draws at the points of a grid of COLUMNS x ROWS cells.
uniform mat4 to_clip;
uniform float lobe;  // 0: a ball; else a lobe, as far from the middle as |value| times this

out vec3 value;
out float facing;  // cosine to the eye

void main() {
    int cell = gl_VertexID / 6;
    int corner = gl_VertexID % 6;
    int column = cell % COLUMNS + (corner == 1 || corner == 2 || corner == 4 ? 1 : 0);
    int row = cell / COLUMNS + (corner == 2 || corner == 4 || corner == 5 ? 1 : 0);
    float phi = 6.2831853 * float(column % COLUMNS) / float(COLUMNS);
    float theta = 3.1415927 * float(row) / float(ROWS);
    vec3 s = vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
    value = evaluated(s);
    facing = -2.0 * (to_clip * vec4(s, 0.0)).z;
    gl_Position = to_clip * vec4(lobe == 0.0 ? s : s * (lobe * abs(value.g)), 1.0);
}
