// Below tone.glsl and pixel_radiance().
uniform int mode;  // as in picture.frag: 0 or 2

out vec4 color;

void main() {
    vec3 radiance = pixel_radiance();
    color = vec4(mode == 0 ? shown(radiance) : radiance, 1.0);
}
