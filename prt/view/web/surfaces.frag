// Below tone.glsl. As prt/rays/receivers_at.hpp and prt/runtime/surface_colors.hpp have it.
precision highp sampler2D;
precision highp usampler2D;

in vec3 radiance;
in vec3 reaching;
in vec3 emitted;
in vec3 tint;
in vec2 atlas_place;
in vec2 picture_place;
flat in int atlas;

uniform sampler2D radiances;   // of the receivers, 4096 a row, as the next two
uniform sampler2D albedos;
uniform sampler2D emissions;
uniform usampler2D receivers;  // of the pixels of all atlases, 4096 a row
uniform ivec3 atlases[32];     // first pixel, width, height
uniform bool has_picture;
uniform sampler2D picture;
uniform int mode;  // 0 picture, 2 radiance itself

out vec4 color;

ivec2 in_rows(int number) { return ivec2(number % 4096, number / 4096); }

// Adds the part of a pixel of the atlas.
void add_receiver(ivec2 pixel, float part, inout vec3 sent, inout vec3 came, inout vec3 own) {
    ivec3 of = atlases[atlas - 1];
    ivec2 inside = clamp(pixel, ivec2(0), of.yz - 1);
    ivec2 place = in_rows(int(texelFetch(receivers, in_rows(of.x + inside.x + of.y * inside.y), 0).r));
    vec3 all = texelFetch(radiances, place, 0).rgb;
    vec3 shining = texelFetch(emissions, place, 0).rgb;
    vec3 albedo = texelFetch(albedos, place, 0).rgb;
    sent += part * all;
    own += part * shining;
    came += part * mix((all - shining) / max(albedo, 1e-20), vec3(0.0), equal(albedo, vec3(0.0)));
}

void main() {
    vec3 sent = radiance, came = reaching, own = emitted;
    if (atlas > 0) {
        vec2 size = vec2(atlases[atlas - 1].yz);
        vec2 at = vec2(atlas_place.x, 1.0 - atlas_place.y) * size - 0.5;
        ivec2 first = ivec2(floor(at));
        vec2 part = at - floor(at);
        sent = came = own = vec3(0.0);
        add_receiver(first, (1.0 - part.x) * (1.0 - part.y), sent, came, own);
        add_receiver(first + ivec2(1, 0), part.x * (1.0 - part.y), sent, came, own);
        add_receiver(first + ivec2(0, 1), (1.0 - part.x) * part.y, sent, came, own);
        add_receiver(first + ivec2(1, 1), part.x * part.y, sent, came, own);
    }
    if (has_picture) sent = came * min(tint * texture(picture, picture_place).rgb, 1.0) + own;
    color = vec4(mode == 0 ? shown(sent) : sent, 1.0);
}
