#version 300 es
// A vertex of a surface whose pixels take their light from texels of an atlas, or their color from a picture.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 radiance_of_vertex;
layout(location = 3) in vec3 place_in_atlas;    // u, v, number of the atlas + 1 or 0
layout(location = 4) in vec2 place_in_picture;  // u, v
layout(location = 5) in vec3 tint_of_vertex;
layout(location = 6) in vec3 albedo_of_vertex;
layout(location = 7) in vec3 emitted_by_vertex;

uniform mat4 to_clip;

out vec3 radiance;
out vec3 reaching;  // the reflected radiance over the albedo
out vec3 emitted;
out vec3 tint;
out vec2 atlas_place;
out vec2 picture_place;
flat out int atlas;

void main() {
    radiance = radiance_of_vertex;
    reaching = mix((radiance_of_vertex - emitted_by_vertex) / max(albedo_of_vertex, 1e-20), vec3(0.0), equal(albedo_of_vertex, vec3(0.0)));
    emitted = emitted_by_vertex;
    tint = tint_of_vertex;
    atlas_place = place_in_atlas.xy;
    atlas = int(place_in_atlas.z);
    picture_place = vec2(place_in_picture.x, 1.0 - place_in_picture.y);
    gl_Position = to_clip * vec4(position, 1.0);
}
