
// The four receivers around a place of an atlas, bilinear, as prt/rays/receivers_at.hpp has them.
precision highp usampler2D;
uniform usampler2D receivers;  // of the pixels of all atlases, 4096 a row
uniform ivec3 atlases[32];     // first pixel, width, height

struct Receivers {
    ivec4 number;
    vec4 part;
};

int receiver_at(ivec3 atlas, ivec2 pixel) {
    ivec2 inside = clamp(pixel, ivec2(0), atlas.yz - 1);
    int i = atlas.x + inside.x + atlas.y * inside.y;
    return int(texelFetch(receivers, ivec2(i % 4096, i / 4096), 0).r);
}

// place: (0, 0) is the lower left corner; number: of the atlas, from 0.
Receivers receivers_at(vec2 place, int number) {
    ivec3 atlas = atlases[number];
    vec2 at = vec2(place.x, 1.0 - place.y) * vec2(atlas.yz) - 0.5;
    ivec2 first = ivec2(floor(at));
    vec2 part = at - floor(at);
    return Receivers(ivec4(receiver_at(atlas, first), receiver_at(atlas, first + ivec2(1, 0)),
                           receiver_at(atlas, first + ivec2(0, 1)), receiver_at(atlas, first + ivec2(1, 1))),
                     vec4((1.0 - part.x) * (1.0 - part.y), part.x * (1.0 - part.y), (1.0 - part.x) * part.y,
                          part.x * part.y));
}
