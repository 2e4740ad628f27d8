#include "tests/bench/sharp_control.hpp"

#if defined(SHFORGE_SHARP)

#include <cmath>

namespace sh::bench {

SharpControl::SharpControl(int degree, std::span<const double> z, int around, bool with_fourier)
    : flags_(SHARP_DP | SHARP_NO_OPENMP | (with_fourier ? 0 : SHARP_NO_FFT)) {
  const int rings = static_cast<int>(z.size());
  const int stored = with_fourier ? around : degree + 1;  // values, or complex Fourier coefficients
  std::vector<int> counts(rings, stored), strides(rings, 1), orders;
  std::vector<std::ptrdiff_t> places, starts;
  std::vector<double> first(rings, 0.0), theta;
  for (int i = 0; i < rings; ++i) {
    places.push_back(static_cast<std::ptrdiff_t>(i) * stored);
    theta.push_back(std::acos(z[i]));
  }
  sharp_make_geom_info(rings, counts.data(), places.data(), strides.data(), first.data(), theta.data(), nullptr,
                       &geometry_);
  for (int m = 0; m <= degree; ++m) {  // a pair of orders m and -m for each degree, as those of this project
    orders.push_back(m);
    starts.push_back(static_cast<std::ptrdiff_t>(m) * (2 * degree + 1 - m) / 2);
  }
  sharp_make_general_alm_info(degree, degree + 1, 1, orders.data(), starts.data(), SHARP_REAL_HARMONICS, &orders_);
  coefficients_.assign((static_cast<std::size_t>(degree) + 1) * (degree + 2), 0.5);
  map_.assign(static_cast<std::size_t>(rings) * stored * (with_fourier ? 1 : 2), 0.5);
}

SharpControl::~SharpControl() {
  sharp_destroy_alm_info(orders_);
  sharp_destroy_geom_info(geometry_);
}

void SharpControl::run(sharp_jobtype job) const {
  void* coefficients = coefficients_.data();
  void* map = map_.data();
  sharp_execute(job, 0, &coefficients, &map, geometry_, orders_, flags_, nullptr, nullptr);
}

}  // namespace sh::bench

#endif
