// Below tone.glsl.
in vec3 radiance;
in float place;

uniform int mode;  // 0 picture, 1 false colors of the difference, 2 radiance itself

out vec4 color;

// Lightness rises evenly, as in prt/study/error_picture.hpp.
vec3 false_color(float at) {
    vec3 stops[5] = vec3[5](vec3(16, 14, 30), vec3(78, 28, 120), vec3(190, 44, 92), vec3(242, 130, 34), vec3(252, 246, 170));
    int first = min(int(at * 4.0), 3);
    return mix(stops[first], stops[first + 1], at * 4.0 - float(first)) / 255.0;
}

void main() {
    if (mode == 0) color = vec4(shown(radiance), 1.0);
    if (mode == 1) color = vec4(false_color(place), 1.0);
    if (mode == 2) color = vec4(radiance, 1.0);
}
