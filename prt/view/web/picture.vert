#version 300 es
// A vertex with its radiance, and that of another transfer of the same mesh.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 radiance_of_vertex;
layout(location = 2) in vec3 other_radiance;

uniform mat4 to_clip;
uniform float reference;  // root mean square of the radiance

out vec3 radiance;
out float place;  // of the difference on a logarithmic scale: 0 at 1e-4 of the reference, 1 at the reference

void main() {
    radiance = radiance_of_vertex;
    float difference = length(radiance_of_vertex - other_radiance) / (1.7320508 * reference);
    place = clamp(log(max(difference, 1e-4) / 1e-4) / log(1e4), 0.0, 1.0);
    gl_Position = to_clip * vec4(position, 1.0);
}
