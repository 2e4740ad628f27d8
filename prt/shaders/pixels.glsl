
// What pixels take from vertices, with perspective. Above: BETWEEN, `out` of vertices or `in` of pixels; CARRIED, 4-vectors
// of the radiance that reaches a vertex (red, green, blue), unless one radiance reaches all; MAPS if there are normal maps;
// PICTURES if pictures give the albedo; ATLASES if faces lie in atlases.
BETWEEN vec3 at_position;
BETWEEN vec3 at_normal;
BETWEEN vec3 at_albedo;
#ifdef LOBES
BETWEEN vec4 at_lobe;  // reflectance, exponent
#endif
#ifdef BRDFS
BETWEEN float at_brdf;
#endif
#ifdef EMITTED
BETWEEN vec3 at_emitted;
#endif
#ifdef CARRIED
BETWEEN vec4 at_reaching[CARRIED];
#endif
#ifdef PICTURES
BETWEEN vec2 at_picture;  // coordinates
BETWEEN vec3 at_tint;
#endif
#ifdef MAPS
BETWEEN vec3 at_texture;  // coordinates, 1 + number of the normal map or 0
BETWEEN vec3 at_tangent;
BETWEEN vec3 at_mirrored;
#endif
#ifdef ATLASES
BETWEEN vec3 at_atlas;  // coordinates, 1 + number of the atlas or 0
#endif
