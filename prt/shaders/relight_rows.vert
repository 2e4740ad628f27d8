// Exit radiance of a vertex from its baked transfer vector. Below a #version line, with
//   COUNT     coefficients of a channel, (degree+1)^2
//   CHANNELS  of the transfer: 1 (DU, DS: times the albedo) or 3 (DI: holds it)
//   WHITE     defined: a light with one channel for all colors
// defined; `prt shader` writes it all.
#ifdef GL_ES
precision highp float;
precision highp int;
precision highp sampler2D;
#endif

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 albedo;  // linear RGB; CHANNELS 3 does not read it
layout(location = 3) in vec3 emitted;  // the section `emitted` of the file; disabled without it, which reads 0

// The file's section `transfer` unchanged: R32F, 2048 wide, number i in column i % 2048 of row i / 2048. Nearest.
uniform sampler2D transfer;
// Coefficients of the light's radiance in the object's own axes: turned by the inverse of its rotation, once an object.
#ifdef WHITE
uniform float light[COUNT];
#else
uniform vec3 light[COUNT];  // red, green, blue
#endif
uniform mat4 to_clip;

out vec3 radiance;  // linear; ringing may make it slightly negative

float transfer_number(int i) { return texelFetch(transfer, ivec2(i % 2048, i / 2048), 0).r; }

void main() {
    vec3 sum = vec3(0.0);
    int row = gl_VertexID * (CHANNELS * COUNT);
    for (int i = 0; i < COUNT; ++i) {
#if CHANNELS == 3
        vec3 t = vec3(transfer_number(row + i), transfer_number(row + COUNT + i), transfer_number(row + 2 * COUNT + i));
#else
        float t = transfer_number(row + i);
#endif
        sum += t * light[i];
    }
#if CHANNELS == 3
    radiance = sum + emitted;
#else
    radiance = albedo * sum + emitted;
#endif
    gl_Position = to_clip * vec4(position, 1.0);
}
