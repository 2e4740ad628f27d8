// What a user of the generated headers writes; checks the addition theorem, Y(d).Y(d) = bands^2 / (4 pi).
#include <cmath>
#include <cstdio>
#include <generated/cpp/basis.hpp>

int main() {
  double values[25];
  sh::basis<4>(0.6, 0.0, 0.8, values);
  double power = 0;
  for (const double value : values) power += value * value;
  const bool agree = std::fabs(power - 25 / (16 * std::atan(1.0))) < 1e-14;
  std::puts(agree ? "agree" : "differ");
  return agree ? 0 : 1;
}
