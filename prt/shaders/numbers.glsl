// Number i of a texture of numbers, nearest: 2048 wide with one number a texel; where PACKED is defined, of any width with
// four numbers a texel.
#ifdef GL_ES
precision highp float;
precision highp int;
precision highp sampler2D;
#endif

#ifdef PACKED
float number_at(sampler2D from, int i) {
    int texel = i / 4;
    int width = textureSize(from, 0).x;
    return texelFetch(from, ivec2(texel % width, texel / width), 0)[i % 4];
}
#else
float number_at(sampler2D from, int i) { return texelFetch(from, ivec2(i % 2048, i / 2048), 0).r; }
#endif
