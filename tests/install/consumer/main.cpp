// What a user of the installed package writes: the generated basis, the oracle, and the baker's light projection.
#include <cmath>
#include <cstdio>
#include <generated/cpp/basis.hpp>
#include <numeric/basis.hpp>

int main() {
  double kernel[25];
  double oracle[25];
  sh::basis<4>(0.6, 0.0, 0.8, kernel);
  sh::numeric::basis(4, 0.6, 0.0, 0.8, oracle);
  double worst = 0;
  for (int i = 0; i < 25; ++i) worst = std::fmax(worst, std::fabs(kernel[i] - oracle[i]));
  std::puts(worst < 1e-15 ? "agree" : "differ");
  return worst < 1e-15 ? 0 : 1;
}
