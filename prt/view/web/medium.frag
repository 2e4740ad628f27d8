// Below tone.glsl and light.glsl. A ray through the grid of a medium, cell
// by cell and front to back, as prt/medium/lit_medium.cpp: in a cell the optical depth is exact, and the light that it sends
// linear in it between the faces.
precision highp sampler3D;

in vec2 place;

uniform sampler3D sent;        // radiance that a point sends
uniform sampler3D extinction;  // of a point, as a part of the largest
uniform ivec3 counts;          // points along the axes
uniform vec3 eye;              // in cells
uniform mat3 to_cells;         // right, up and ahead of the camera, in cells a unit of the scene
uniform mat3 to_world;         // the same axes in the world
uniform vec2 half_size;        // of the picture at distance 1
uniform float densest;         // the largest extinction
uniform int mode;              // 0 picture, 2 radiance itself, where it covers at least half of what is behind
uniform bool lit_behind;       // the light is the background, not grey

out vec4 color;

const float kGrey = 0.3;        // after exposure
const float kOpaque = 1e-5;     // less of the light behind is not seen

vec3 at(vec3 p) { return (p + 0.5) / vec3(counts); }
float density(vec3 p) { return densest * textureLod(extinction, at(p), 0.0).r; }

// The parts of a cell's radiance at its near and far face, and of the light behind.
vec3 weights(float depth) {
    float through = exp(-depth);
    bool is_small = depth < 0.02;
    float taken = is_small ? depth * (1.0 - depth * (0.5 - depth / 6.0)) : 1.0 - through;
    float far = is_small ? depth * (0.5 - depth * (1.0 / 3.0 - depth / 8.0)) : taken / depth - through;
    return vec3(taken - far, far, through);
}

vec3 behind(vec3 direction) { return lit_behind ? max(evaluated(direction), 0.0) : vec3(kGrey / exposure); }

void main() {
    vec3 ray = normalize(vec3(place * half_size, 1.0));
    vec3 onward = to_cells * ray;  // a unit of the scene
    vec3 most = vec3(counts - 1);
    vec3 safe = mix(onward, vec3(1e-20), equal(onward, vec3(0.0)));
    vec3 low = -eye / safe, high = (most - eye) / safe;
    vec3 enter = min(low, high), leave = max(low, high);
    float t = max(max(enter.x, enter.y), max(enter.z, 0.0));
    float last = min(leave.x, min(leave.y, leave.z));
    vec3 start = eye + t * onward;
    // When the ray meets the next plane along each axis.
    vec3 plane = mix(ceil(start) - 1.0, floor(start) + 1.0, greaterThan(onward, vec3(0.0)));
    vec3 next = (plane - eye) / safe;
    vec3 cell = abs(1.0 / safe);
    vec3 radiance = vec3(0.0), near = vec3(0.0);
    float through = 1.0;
    bool is_inside = false;
    int most_cells = counts.x + counts.y + counts.z + 3;
    for (int i = 0; i < most_cells && t < last && through > kOpaque; ++i) {
        float to = min(min(next.x, next.y), min(next.z, last));
        next += mix(vec3(0.0), cell, lessThanEqual(next, vec3(to)));
        if (to <= t) continue;
        vec3 a = eye + t * onward, b = eye + to * onward;
        vec3 middle = 0.5 * (a + b), node = 0.28867513 * (b - a);
        float depth = 0.5 * (to - t) * (density(middle - node) + density(middle + node));
        t = to;
        if (depth <= 0.0) {
            is_inside = false;
            continue;
        }
        if (!is_inside) near = textureLod(sent, at(a), 0.0).rgb;
        is_inside = true;
        vec3 far = textureLod(sent, at(b), 0.0).rgb;
        vec3 part = through * weights(depth);
        radiance += part.x * near + part.y * far;
        through = part.z;
        near = far;
    }
    if (through <= kOpaque) through = 0.0;
    if (mode == 2) {
        color = vec4(radiance, through <= 0.5 ? 1.0 : 0.0);
    } else {
        color = vec4(shown(radiance + through * behind(to_world * ray)), 1.0);
    }
}
