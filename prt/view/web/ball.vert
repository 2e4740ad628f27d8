// A function on the sphere, evaluated by a generated function at the points of a grid of COLUMNS x ROWS cells. Above:
// COUNT coefficients of a channel, EVALUATE.
uniform vec3 coefficients[COUNT];  // red, green, blue
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
    float c[3 * COUNT];
    for (int i = 0; i < 3 * COUNT; ++i) c[i] = coefficients[i % COUNT][i / COUNT];
    float rgb[3];
    EVALUATE(c, s.x, s.y, s.z, rgb);
    value = vec3(rgb[0], rgb[1], rgb[2]);
    facing = -2.0 * (to_clip * vec4(s, 0.0)).z;
    gl_Position = to_clip * vec4(lobe == 0.0 ? s : s * (lobe * abs(value.g)), 1.0);
}
