// The colour of a Gaussian splat in a direction, degree 3, as renderers usually write it: one splat after the other, a
// polynomial for every basis function, three channels (Kerbl, Kopanas, Leimkuehler and Drettakis 2023).
#pragma once

namespace sh::control {

/// c: 16 coefficients of 3 channels each, c[3 * k + channel]; rgb: 3.
inline void splat_colour(const float* c, float x, float y, float z, float* rgb) {
  const float xx = x * x;
  const float yy = y * y;
  const float zz = z * z;
  const float xy = x * y;
  const float yz = y * z;
  const float xz = x * z;
  for (int channel = 0; channel < 3; ++channel) {
    const auto at = [&](int k) { return c[3 * k + channel]; };
    float colour = 0.28209479F * at(0);
    colour += 0.48860251F * y * at(1) + 0.48860251F * z * at(2) + 0.48860251F * x * at(3);
    colour += 1.0925485F * xy * at(4) + 1.0925485F * yz * at(5) + 0.31539157F * (2 * zz - xx - yy) * at(6) +
              1.0925485F * xz * at(7) + 0.54627422F * (xx - yy) * at(8);
    colour += 0.59004359F * y * (3 * xx - yy) * at(9) + 2.8906114F * xy * z * at(10) +
              0.45704580F * y * (4 * zz - xx - yy) * at(11) + 0.37317633F * z * (2 * zz - 3 * xx - 3 * yy) * at(12) +
              0.45704580F * x * (4 * zz - xx - yy) * at(13) + 1.4453057F * z * (xx - yy) * at(14) +
              0.59004359F * x * (xx - 3 * yy) * at(15);
    rgb[channel] = colour;
  }
}

}  // namespace sh::control
