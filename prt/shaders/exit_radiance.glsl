
// What leaves a place towards the eye; ringing may make it slightly negative.
vec3 exit_radiance(Place place, vec3 to_eye, float reaching[3 * COUNT]) {
#if defined(LOBES) && defined(BRDFS)
    if (place.brdf > 0.5) return of_brdf(place, to_eye, reaching);
    return of_lobes(place, to_eye, reaching);
#elif defined(BRDFS)
    return of_brdf(place, to_eye, reaching);
#else
    return of_lobes(place, to_eye, reaching);
#endif
}
