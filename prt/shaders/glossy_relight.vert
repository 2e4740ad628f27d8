
uniform vec3 eye;  // in the coordinates of the mesh

out vec3 radiance;  // linear

void main() {
    float reaching[3 * COUNT];
    transferred(reaching);
    Place place = Place(normal, albedo, specular, exponent, brdf);
    radiance = exit_radiance(place, unit(eye - position), reaching) + emitted;
    gl_Position = to_clip * vec4(position, 1.0);
}
