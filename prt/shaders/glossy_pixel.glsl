
// A pixel of a glossy surface: the radiance between the vertices, met by the lobes of this place [SloanKautzSnyder02,
// equation 12].
uniform vec3 eye;  // in the coordinates of the mesh
#ifdef PICTURES
uniform bool has_picture;
uniform sampler2D picture;  // row by row from the top
#endif

vec3 pixel_radiance() {  // linear
    float reaching[3 * COUNT];
#ifdef CARRIED
    for (int i = 0; i < 3 * COUNT; ++i) reaching[i] = at_reaching[i / 4][i % 4];
#else
    direct(0, reaching);
#endif
#ifdef EMITTED
    vec3 emitted = at_emitted;
#else
    vec3 emitted = vec3(0.0);
#endif
#ifdef ATLASES
    if (at_atlas.z > 0.5) between_texels(receivers_at(at_atlas.xy, int(at_atlas.z - 0.5)), reaching, emitted);
#endif
    Place place = Place(unit(at_normal), at_albedo, vec3(0.0), 0.0, 0.0);
#ifdef PICTURES
    if (has_picture) place.albedo = min(at_tint * texture(picture, at_picture).rgb, 1.0);
#endif
#ifdef LOBES
    place.specular = at_lobe.rgb;
    place.exponent = at_lobe.a;
#endif
#ifdef BRDFS
    place.brdf = at_brdf;
#endif
#ifdef MAPS
    place.normal = mapped_normal(place.normal);
#endif
    return exit_radiance(place, unit(eye - at_position), reaching) + emitted;
}
