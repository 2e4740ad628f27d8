
// What leaves towards the eye over a diffuse surface and a lobe. Above: COUNT, BANDS, COSINE, ZONAL, GATHER.

// Band l of (e+1)/(2 pi) max(0, cos)^e: (e+1) times the integral of t^e P_l(t) over 0..1 [Hobson31].
float lobe_factor(int l, float e) {
    float factor = l % 2 == 0 ? 1.0 : (e + 1.0) / (e + 2.0);
    for (int k = 2 + l % 2; k <= l; k += 2) factor *= (e - float(k) + 2.0) / (e + float(k) + 1.0);
    return factor;
}

vec3 gathered(float zonal[BANDS], vec3 direction, float reaching[3 * COUNT]) {
    float lobe[COUNT];
    ZONAL(zonal, direction.x, direction.y, direction.z, lobe);
    float rgb[3];
    GATHER(lobe, reaching, rgb);
    return vec3(rgb[0], rgb[1], rgb[2]);
}

vec3 of_lobes(Place place, vec3 to_eye, float reaching[3 * COUNT]) {
    float zonal[BANDS] = COSINE;
    vec3 sums = place.albedo * gathered(zonal, place.normal, reaching);
    for (int l = 0; l < BANDS; ++l) zonal[l] = lobe_factor(l, place.exponent) * sqrt((2.0 * float(l) + 1.0) / 12.566371);
    vec3 about = unit(2.0 * dot(place.normal, to_eye) * place.normal - to_eye);
    return sums + place.specular * gathered(zonal, about, reaching);
}
