
// What leaves towards the eye over BRDFs. Above: COUNT, BANDS, VIEWS of a table, EVEN numbers of a view, ROTATE, GATHER.
//
// A vertex has the number 4 t + n: its n parts stand in the tables t, t + 1, ...; 1: white, 2: of the color of the albedo
// and white, 3: red, green, blue; 0: no BRDF.
uniform sampler2D tables;  // numbers.glsl

float table_number(int i) { return number_at(tables, i); }

vec3 of_brdf(Place place, vec3 to_eye, float reaching[3 * COUNT]) {
    vec3 normal = place.normal;
    // The frame of the surface: z is the normal, and the eye stands over x >= 0.
    float cosine = dot(normal, to_eye);
    vec3 x = to_eye - cosine * normal;
    float sine = length(x);
    if (sine <= 1e-6) {
        bool is_up = dot(normal.xy, normal.xy) <= 1e-10 * normal.z * normal.z;
        x = is_up ? vec3(0.0, -normal.z, normal.y) : vec3(-normal.y, normal.x, 0.0);
    }
    x = normalize(x);
    x = normalize(x - dot(x, normal) * normal);
    vec3 y = cross(normal, x);
    float frame[9] = float[9](x.x, y.x, normal.x, x.y, y.y, normal.y, x.z, y.z, normal.z);
    // Four neighboring views, and the weights of the cubic through them; below the surface those of grazing view.
    float view = cosine > 0.0 ? atan(sine, cosine) * (float(VIEWS - 1) / 1.5707963) : float(VIEWS - 1);
    int before = clamp(int(view) - 1, 0, VIEWS - 4);
    float t = view - float(before);
    vec4 weights = vec4(-(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0, t * (t - 2.0) * (t - 3.0) / 2.0,
                        -t * (t - 1.0) * (t - 3.0) / 2.0, t * (t - 1.0) * (t - 2.0) / 6.0);
    int number = int(place.brdf + 0.5);
    int table = number / 4;
    int parts = number % 4;
    vec3 sums = vec3(0.0);
    for (int part = 0; part < parts; ++part) {
        int i = ((table + part) * VIEWS + before) * EVEN;
        float lobe[COUNT];
        for (int l = 0; l < BANDS; ++l) {
            for (int m = -l; m < 0; ++m) lobe[l * (l + 1) + m] = 0.0;
            for (int m = 0; m <= l; ++m, ++i) {
                vec4 four = vec4(table_number(i), table_number(i + EVEN), table_number(i + 2 * EVEN),
                                 table_number(i + 3 * EVEN));
                lobe[l * (l + 1) + m] = dot(weights, four);
            }
        }
        float turned[COUNT];
        ROTATE(frame, lobe, turned);
        float rgb[3];
        GATHER(turned, reaching, rgb);
        vec3 color = part + 1 == parts ? vec3(1.0) : place.albedo;
        if (parts == 3) color = vec3(equal(ivec3(part), ivec3(0, 1, 2)));
        sums += color * vec3(rgb[0], rgb[1], rgb[2]);
    }
    return sums;
}
