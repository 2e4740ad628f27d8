#include "prt/material/lobe.hpp"

namespace sh::prt {

double phong_factor(int l, double exponent) {
  double factor = l % 2 == 0 ? 1.0 : (exponent + 1.0) / (exponent + 2.0);
  for (int k = l % 2 + 2; k <= l; k += 2) factor *= (exponent - k + 2) / (exponent + k + 1);
  return factor;
}

double phong_share(int degree, double exponent) {
  double bands = 0.0;
  for (int l = 0; l <= degree; ++l) bands += (2 * l + 1) * phong_factor(l, exponent) * phong_factor(l, exponent);
  return bands * (2.0 * exponent + 1.0) / (2.0 * (exponent + 1.0) * (exponent + 1.0));
}

}  // namespace sh::prt
