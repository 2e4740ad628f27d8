
void main() {
    float reaching[3 * COUNT];
    transferred(reaching);
    vec3 to_eye = unit(eye - position);
#if defined(ROTATE) && defined(ZONAL)
    if (brdf > 0.0) {
        radiance = of_brdf(to_eye, reaching);
    } else {
        radiance = of_lobes(to_eye, reaching);
    }
#elif defined(ROTATE)
    radiance = of_brdf(to_eye, reaching);
#else
    radiance = of_lobes(to_eye, reaching);
#endif
    radiance += emitted;
    gl_Position = to_clip * vec4(position, 1.0);
}
