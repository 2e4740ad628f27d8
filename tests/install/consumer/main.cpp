// What a user of the installed package writes: the generated basis, the oracle, and the baker's light.
#include <cmath>
#include <cstdio>
#include <generated/cpp/basis.hpp>
#include <numeric/oracle/basis.hpp>
#include <prt/light/light_coefficients.hpp>

int main() {
  double kernel[25];
  double oracle[25];
  sh::basis<4>(0.6, 0.0, 0.8, kernel);
  sh::numeric::basis(4, 0.6, 0.0, 0.8, oracle);
  sh::prt::LightCoefficients light = sh::prt::LightCoefficients::zero(4);
  for (unsigned i = 0; i < 25; ++i) light.at(1, i) = oracle[i];
  double worst = 0;
  double power = 0;  // Y(d).Y(d) = bands^2 / (4 pi), the addition theorem
  for (int i = 0; i < 25; ++i) worst = std::fmax(worst, std::fabs(kernel[i] - oracle[i]));
  for (int i = 0; i < 25; ++i) power += kernel[i] * kernel[i];
  worst = std::fmax(worst, std::fabs(sh::prt::radiance(light, {0.6, 0.0, 0.8}).y() - power));
  std::puts(worst < 1e-14 ? "agree" : "differ");
  return worst < 1e-14 ? 0 : 1;
}
