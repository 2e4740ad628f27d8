precision highp float;

// Linear radiance to a screen color: exposure, tone curve, sRGB, as prt/image/tone_map.hpp.
uniform float exposure;
uniform int tone;  // 0 neutral, 1 Reinhard, 2 linear

// [Khronos Group, "Khronos PBR Neutral Tone Mapper", 2024]
vec3 neutral(vec3 color) {
    float darkest = min(color.r, min(color.g, color.b));
    color -= darkest < 0.08 ? darkest - 6.25 * darkest * darkest : 0.04;
    float peak = max(color.r, max(color.g, color.b));
    if (peak < 0.76) return color;
    float compressed = 1.0 - 0.24 * 0.24 / (peak + 0.24 - 0.76);
    color *= compressed / peak;
    return mix(vec3(compressed), color, 1.0 / (0.15 * (peak - compressed) + 1.0));
}

vec3 srgb(vec3 linear) {
    linear = clamp(linear, 0.0, 1.0);
    return mix(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}

vec3 shown(vec3 radiance) {
    vec3 color = exposure * max(radiance, 0.0);
    if (tone == 0) color = neutral(color);
    if (tone == 1) color /= 1.0 + dot(color, vec3(0.2126, 0.7152, 0.0722));  // [Reinhard02] equation 3
    return srgb(color);
}
