
// A place on a surface, and what its lobes and BRDFs need.
struct Place {
    vec3 normal;    // unit
    vec3 albedo;    // linear RGB
    vec3 specular;  // linear RGB reflectance of the lobe
    float exponent;
    float brdf;     // below
};

// Of length 1, or 0 if v is 0.
vec3 unit(vec3 v) {
    float size = length(v);
    return size > 0.0 ? v / size : vec3(0.0);
}
