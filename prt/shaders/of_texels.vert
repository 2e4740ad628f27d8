
// What of_texels of texels.glsl holds of a receiver: draw VERTICES points in OF_TEXEL instances and capture `of_texel`. Above:
// glossy.vert; CARRIED unless one radiance reaches all.
out vec4 of_texel;

void main() {
    of_texel = vec4(emitted, 0.0);
#ifdef CARRIED
    if (gl_InstanceID < CARRIED) {
        float reaching[3 * COUNT];
        transferred(reaching);
        for (int i = 0; i < 4; ++i) of_texel[i] = 4 * gl_InstanceID + i < 3 * COUNT ? reaching[4 * gl_InstanceID + i] : 0.0;
    }
#endif
    gl_Position = vec4(0.0);
}
