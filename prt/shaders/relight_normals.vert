// Exit radiance of a vertex that nothing shadows, from its normal alone: the light is turned into the object's axes by the
// generated rotation and gathered over the hemisphere by the generated irradiance. Below a #version line, with
//   COUNT                coefficients of a channel, (degree+1)^2
//   ROTATE, IRRADIANCE   the generated functions rotate_l<degree>, irradiance_evaluate_l<degree>, which stand above
//   WHITE                defined: a light with one channel for all colors
// defined; `prt shader` writes it all.
#ifdef GL_ES
precision highp float;
precision highp int;
#endif

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 albedo;  // linear RGB
layout(location = 2) in vec3 normal;  // unit, in the axes of the object
layout(location = 3) in vec3 emitted;  // the section `emitted` of the file; disabled without it, which reads 0

// Coefficients of the light's radiance in world axes.
#ifdef WHITE
uniform float light[COUNT];
#else
uniform vec3 light[COUNT];  // red, green, blue
#endif
uniform float rotation[9];  // world axes to the object's, row by row
uniform mat4 to_clip;

out vec3 radiance;  // linear

float exit_over_albedo(float coefficients[COUNT]) {
    float turned[COUNT];
    ROTATE(rotation, coefficients, turned);
    return IRRADIANCE(turned, normal.x, normal.y, normal.z) / 3.1415927;
}

void main() {
    float channel[COUNT];
#ifdef WHITE
    for (int i = 0; i < COUNT; ++i) channel[i] = light[i];
    radiance = albedo * exit_over_albedo(channel) + emitted;
#else
    vec3 sum;
    for (int i = 0; i < COUNT; ++i) channel[i] = light[i].r;
    sum.r = exit_over_albedo(channel);
    for (int i = 0; i < COUNT; ++i) channel[i] = light[i].g;
    sum.g = exit_over_albedo(channel);
    for (int i = 0; i < COUNT; ++i) channel[i] = light[i].b;
    sum.b = exit_over_albedo(channel);
    radiance = albedo * sum + emitted;
#endif
    gl_Position = to_clip * vec4(position, 1.0);
}
