
// Light between texels. Above: atlas.glsl, VERTICES, OF_TEXEL.

// Number i of receiver r: component i % 4 of texel t = i / 4 * VERTICES + r, in column t % 2048 of row t / 2048; red,
// green and blue of the radiance that reaches it, then, from number 4 CARRIED on, its emitted radiance (of_texels.vert).
uniform sampler2D of_texels;

void between_texels(Receivers around, inout float reaching[3 * COUNT], inout vec3 emitted) {
#ifdef CARRIED
    for (int i = 0; i < 3 * COUNT; ++i) reaching[i] = 0.0;
#endif
    emitted = vec3(0.0);
    for (int k = 0; k < 4; ++k) {
        for (int four = 0; four < OF_TEXEL; ++four) {
            int t = four * VERTICES + around.number[k];
            vec4 values = around.part[k] * texelFetch(of_texels, ivec2(t % 2048, t / 2048), 0);
#ifdef CARRIED
            if (four < CARRIED) {
                for (int i = 0; i < 4 && 4 * four + i < 3 * COUNT; ++i) reaching[4 * four + i] += values[i];
                continue;
            }
#endif
            emitted += values.rgb;
        }
    }
}
