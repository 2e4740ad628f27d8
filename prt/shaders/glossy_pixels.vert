
#ifdef PICTURES
layout(location = 12) in vec2 picture_place;  // coordinates; (0, 0) is the lower left corner
layout(location = 13) in vec3 tint;
#endif
#ifdef MAPS
layout(location = 9) in vec3 texture_place;      // coordinates, 1 + number of the normal map or 0
layout(location = 10) in vec3 tangent;           // unit, along u: of the faces around that show the picture,
layout(location = 11) in vec3 mirrored_tangent;  // and of those that mirror it
#endif
#ifdef ATLASES
layout(location = 14) in vec3 place_in_atlas;  // coordinates, 1 + number of the atlas or 0
#endif

void main() {
#ifdef CARRIED
    float reaching[3 * COUNT];
    transferred(reaching);
    for (int i = 0; i < 4 * CARRIED; ++i) at_reaching[i / 4][i % 4] = i < 3 * COUNT ? reaching[i] : 0.0;
#endif
    at_position = position;
    at_normal = normal;
    at_albedo = albedo;
#ifdef LOBES
    at_lobe = vec4(specular, exponent);
#endif
#ifdef BRDFS
    at_brdf = brdf;
#endif
#ifdef EMITTED
    at_emitted = emitted;
#endif
#ifdef PICTURES
    at_picture = vec2(picture_place.x, 1.0 - picture_place.y);
    at_tint = tint;
#endif
#ifdef MAPS
    at_texture = texture_place;
    at_tangent = tangent;
    at_mirrored = mirrored_tangent;
#endif
#ifdef ATLASES
    at_atlas = place_in_atlas;
#endif
    gl_Position = to_clip * vec4(position, 1.0);
}
