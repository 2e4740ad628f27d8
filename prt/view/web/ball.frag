// Below tone.glsl. The radiance of a light, or a lobe; where the function is negative, stripes.
in vec3 value;
in float facing;

uniform int mode;  // 0 light, 1 lobe, 2 light as background: black where it is negative
uniform vec3 accent;

out vec4 color;

void main() {
    vec3 shade = shown(value);
    bool is_negative = min(value.r, min(value.g, value.b)) < 0.0;
    if (mode == 1) shade = (is_negative ? vec3(0.5) : accent) * (0.35 + 0.65 * facing);
    bool is_stripe = fract((gl_FragCoord.x + gl_FragCoord.y) / 9.0) < 0.35;
    if (is_negative && mode == 1 && is_stripe) shade = vec3(0.12);
    if (is_negative && mode == 0) shade = vec3(is_stripe ? 0.95 : 0.08);
    color = vec4(shade, 1.0);
}
