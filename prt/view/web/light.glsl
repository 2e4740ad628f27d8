// A light, or another function on the sphere. Above: a generated function EVALUATE of COUNT coefficients a channel.
uniform vec3 coefficients[COUNT];  // red, green, blue

vec3 evaluated(vec3 s) {
    float c[3 * COUNT];
    for (int i = 0; i < 3 * COUNT; ++i) c[i] = coefficients[i % COUNT][i / COUNT];
    float rgb[3];
    EVALUATE(c, s.x, s.y, s.z, rgb);
    return vec3(rgb[0], rgb[1], rgb[2]);
}
