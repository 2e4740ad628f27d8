
// Exit radiance of a vertex from what its row gives, row_sums above.
//   RECOLORABLE    defined: the rows do not hold the albedo
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 albedo;  // linear RGB; read if RECOLORABLE
layout(location = 3) in vec3 emitted;  // the section `emitted` of the file; disabled without it, which reads 0

uniform mat4 to_clip;

out vec3 radiance;  // linear; ringing may make it slightly negative

void main() {
    radiance = row_sums(gl_VertexID);
#ifdef RECOLORABLE
    radiance *= albedo;
#endif
    radiance += emitted;
    gl_Position = to_clip * vec4(position, 1.0);
}
