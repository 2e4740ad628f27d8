
layout(location = 0) out vec4 radiance;  // linear; alpha 1

void main() { radiance = vec4(pixel_radiance(), 1.0); }
