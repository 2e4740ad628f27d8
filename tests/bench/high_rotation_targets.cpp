// Rotation of degree 20 to 1000 against the recursion of Ivanic and Ruedenberg, and its error at degree 100.
#include <algorithm>
#include <cmath>
#include <string>

#include "numeric/methods/zxz_rows.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/oracle/rotation.hpp"
#include "numeric/oracle/rotation_matrices.hpp"
#include "numeric/sampling/random.hpp"
#include "tests/bench/harness.hpp"

namespace sh::bench {
namespace {

using numeric::methods::rotate_zxz_rows;

std::vector<double> coefficients(int degree) {
  numeric::Random random(1);
  std::vector<double> c(numeric::coefficient_count(degree));
  for (double& v : c) v = random.next();
  return c;
}

// Seconds of one rotation by `rotate`.
template <class Rotate>
std::function<void()> task(int degree, Rotate rotate) {
  return [degree, rotate, c = coefficients(degree), out = coefficients(degree),
          r = numeric::tilted_turn(1.1, 0.7, -0.4)]() mutable {
    rotate(degree, r.data(), c.data(), out.data());
    keep(out[0]);
  };
}

void times(Table& table) {
  table.section("Rotation of high degree, double, one vector", "building and applying; control: Ivanic and Ruedenberg");
  for (const auto& [degree, target] : {std::pair{20, 0.3}, {100, 0.03}}) {
    const auto t = least_times({task(degree, rotate_zxz_rows<double>), task(degree, numeric::rotate<double>)}, 7);
    table.ratio("rotate_zxz_rows, degree " + std::to_string(degree), "us", 1e6 * t[0], 1e6 * t[1], "control", target);
  }
  const auto t = least_times({task(1000, rotate_zxz_rows<double>)}, 3);
  table.remark("rotate_zxz_rows, degree 1000: " + std::to_string(1e3 * t[0]) + " ms");
}

// Largest error of an entry for |c| = 1 where c is the basis at a direction: its image is the basis at the turned one.
double largest_error(int degree) {
  std::vector<double> c = numeric::basis<double>(degree, 0.36, 0.48, -0.8);
  double largest = 0;
  for (const double tilt : {0.0, 1e-12, 2e-4, 0.7, 1.5707963267948966, 3.1}) {
    const auto r = numeric::tilted_turn(1.1, tilt, -0.4);
    const auto at = [&](std::size_t row) { return 0.36 * r[row] + 0.48 * r[row + 1] - 0.8 * r[row + 2]; };
    const auto [x, y, z] = numeric::normalized(at(0), at(3), at(6));
    const std::vector<double> expected = numeric::basis<double>(degree, x, y, z);
    std::vector<double> out(c.size());
    rotate_zxz_rows(degree, r.data(), c.data(), out.data());
    for (std::size_t i = 0; i < c.size(); ++i) largest = std::max(largest, std::abs(out[i] - expected[i]));
  }
  return largest / (degree + 1) * std::sqrt(4 * 3.141592653589793);
}

}  // namespace

void high_rotation(Table& table) {
  times(table);
  for (const int degree : {100, 1000}) {
    table.figure("rotate_zxz_rows, largest error, degree " + std::to_string(degree), "", largest_error(degree), 1e-13);
  }
}

}  // namespace sh::bench
