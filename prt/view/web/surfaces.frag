// Below tone.glsl and prt/shaders/atlas.glsl. As prt/runtime/surface_colors.hpp has it.
precision highp sampler2D;

in vec3 radiance;
in vec3 reaching;
in vec3 emitted;
in vec3 tint;
in vec2 atlas_place;
in vec2 picture_place;
flat in int atlas;

uniform sampler2D radiances;  // of the receivers, 4096 a row, as the next two
uniform sampler2D albedos;
uniform sampler2D emissions;
uniform bool has_picture;
uniform sampler2D picture;
uniform int mode;  // 0 picture, 2 radiance itself

out vec4 color;

// Adds the part of a receiver.
void add_receiver(int number, float part, inout vec3 sent, inout vec3 came, inout vec3 own) {
    ivec2 place = ivec2(number % 4096, number / 4096);
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
        Receivers around = receivers_at(atlas_place, atlas - 1);
        sent = came = own = vec3(0.0);
        for (int k = 0; k < 4; ++k) add_receiver(around.number[k], around.part[k], sent, came, own);
    }
    if (has_picture) sent = came * min(tint * texture(picture, picture_place).rgb, 1.0) + own;
    color = vec4(mode == 0 ? shown(sent) : sent, 1.0);
}
