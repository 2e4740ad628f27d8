
// The normal of a pixel from a map, in the frame of the surface: x the tangent, y on the side towards which v grows, z the
// normal between the vertices. Above: map_first, the first texel of a map, map_width, map_height.
uniform sampler2D normals;  // three numbers a texel of the map, row by row from the top, one map after another (numbers.glsl)

// The maps repeat.
vec3 texel_of_map(int map, int column, int row) {
    int width = map_width[map];
    int height = map_height[map];
    int i = 3 * (map_first[map] + (row + height) % height * width + (column + width) % width);
    return vec3(number_at(normals, i), number_at(normals, i + 1), number_at(normals, i + 2));
}

// (0, 0) is the lower left corner of the picture.
vec3 normal_of_map(int map, vec2 coordinates) {
    vec2 part = coordinates - floor(coordinates);
    vec2 place = vec2(part.x, 1.0 - part.y) * vec2(float(map_width[map]), float(map_height[map])) - 0.5;
    vec2 corner = floor(place);
    vec2 t = place - corner;
    int left = int(corner.x);
    int top = int(corner.y);
    vec3 above = mix(texel_of_map(map, left, top), texel_of_map(map, left + 1, top), t.x);
    vec3 below = mix(texel_of_map(map, left, top + 1), texel_of_map(map, left + 1, top + 1), t.x);
    vec3 n = mix(above, below, t.y);
    return length(n) > 1e-3 ? normalize(n) : vec3(0.0, 0.0, 1.0);
}

// normal: unit, between the vertices.
vec3 mapped_normal(vec3 normal) {
    vec2 across = dFdx(at_texture.xy);
    vec2 up = dFdy(at_texture.xy);
    float area = across.x * up.y - across.y * up.x;
    bool has_area = abs(area) > 1e-5 * max(dot(across, across), dot(up, up));
    bool is_mirrored = has_area && (area < 0.0) == gl_FrontFacing;
    int map = int(at_texture.z + 0.5) - 1;
    if (map < 0) return normal;
    vec3 x = is_mirrored ? at_mirrored : at_tangent;
    x -= dot(x, normal) * normal;
    if (length(x) <= 1e-4) return normal;
    x = normalize(x);
    vec3 y = (is_mirrored ? -1.0 : 1.0) * cross(normal, x);
    vec3 n = normal_of_map(map, at_texture.xy);
    return normalize(n.x * x + n.y * y + n.z * normal);
}
