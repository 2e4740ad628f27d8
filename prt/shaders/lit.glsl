
// The light meets the means and vectors of clusters, once a frame: draw `rows` points in `parts` instances, as relight.json
// says, without the rasterizer; capture `lit` in a buffer of 2048 * height * 16 bytes; bind it as GL_PIXEL_UNPACK_BUFFER and
// copy it to the texture, 2048 x height, GL_RGBA, GL_FLOAT. Above: light_row, NUMBERS, LIT_PART.
#if LIT_PART == 1  // WebGL captures no arrays
out vec4 lit;            // from number 4 gl_InstanceID on
#define LIT(k) lit
#else
out vec4 lit[LIT_PART];  // from number 4 LIT_PART gl_InstanceID on
#define LIT(k) lit[k]
#endif

void main() {
    float numbers[NUMBERS];
    light_row(gl_VertexID, numbers);
    for (int k = 0; k < LIT_PART; ++k) {
        int first = 4 * (gl_InstanceID * LIT_PART + k);
        vec4 four = vec4(0.0);
        for (int i = 0; i < 4 && first + i < NUMBERS; ++i) four[i] = numbers[first + i];
        LIT(k) = four;
    }
    gl_Position = vec4(0.0);
}
