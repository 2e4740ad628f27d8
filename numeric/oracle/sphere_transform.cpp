#include "numeric/oracle/sphere_transform.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>
#include <string>
#include <unsupported/Eigen/FFT>

#include "numeric/oracle/index.hpp"
#include "numeric/oracle/require.hpp"

namespace sh::numeric {
namespace {

using Complex = std::complex<double>;

// Spectra of real rings without the half that is conjugate, and no factor 1 / n; plans stay from one call to the next.
Eigen::FFT<double>& fourier() {
  thread_local Eigen::FFT<double> transform = [] {
    Eigen::FFT<double> made;
    made.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    made.SetFlag(Eigen::FFT<double>::Unscaled);
    return made;
  }();
  return transform;
}

// One value is its own spectrum; Eigen 3.4 writes to a null pointer there.
void to_spectrum(const double* values, int around, Complex* spectrum) {
  if (around == 1) {
    *spectrum = *values;
  } else {
    fourier().fwd(spectrum, values, around);
  }
}
void from_spectrum(const Complex* spectrum, int around, double* values) {
  if (around == 1) {
    *values = spectrum->real();
  } else {
    fourier().inv(values, spectrum, around);
  }
}

// Rings or orders of one task: their numbers share a line of the cache.
constexpr std::size_t kAtOnce = 4;

// Spectra of the rings of one task.
struct Spectra {
  std::size_t size;
  std::vector<Complex> values;

  explicit Spectra(int around) : size(static_cast<std::size_t>(around) / 2 + 1), values(kAtOnce * size) {}
  Complex* of(std::size_t ring) { return &values[ring * size]; }
};

// Y_lm is that times P_lm times a cosine or sine.
double factor(int order) { return order == 0 ? 1.0 : std::numbers::sqrt2; }

// Coefficients of the orders of one task, those of m and -m in pairs.
struct OfOrders {
  int first, last, degree;
  std::vector<double> values[kAtOnce];

  OfOrders(std::size_t from, int of_degree)
      : first(static_cast<int>(from)),
        last(std::min(first + static_cast<int>(kAtOnce) - 1, of_degree)),
        degree(of_degree) {
    for (int m = first; m <= last; ++m) values[m - first].resize(2 * static_cast<std::size_t>(degree - m + 1));
  }
  std::span<double> pairs(int m) { return values[m - first]; }
  // f(l, m, pair), degree by degree.
  template <class F>
  void each(const F& f) {
    for (int l = first; l <= degree; ++l) {
      for (int m = first; m <= std::min(last, l); ++m) f(l, m, &values[m - first][2 * static_cast<std::size_t>(l - m)]);
    }
  }
};

int tasks(std::size_t count) { return static_cast<int>((count + kAtOnce - 1) / kAtOnce); }

}  // namespace

void one_by_one(int count, const std::function<void(int)>& task) {
  for (int i = 0; i < count; ++i) task(i);
}

int smooth_around(int least) {
  for (int n = std::max((least + 3) / 4, 1);; ++n) {
    int rest = n;
    for (const int factor : {2, 3, 5}) {
      while (rest % factor == 0) rest /= factor;
    }
    if (rest == 1) return 4 * n;
  }
}

SphereTransform::SphereTransform(int degree, std::span<const double> z, std::span<const double> sine, int around,
                                 double phi_0, RingLanes lanes)
    : rings_(degree, z, sine, lanes), around_(around) {
  require_range("SphereTransform: around", around, 1);
  if (!std::isfinite(phi_0)) throw std::invalid_argument("SphereTransform: phi_0: expected a finite angle");
  for (int m = 0; m <= degree; ++m) {
    const double c = std::cos(m * phi_0), s = std::sin(m * phi_0);
    const int low = m % around, high = around - low;
    if (2 * low % around == 0) {
      wave_.push_back({low, c, s, 0, 0, 1});
    } else if (low < high) {
      wave_.push_back({low, c, s, s, c, 0.5});
    } else {
      wave_.push_back({high, c, s, -s, -c, 0.5});
    }
  }
}

void SphereTransform::to_map(const Orders& orders, std::size_t ring, std::span<double> map) const {
  const std::size_t count = std::min(kAtOnce, rings() - ring);
  Spectra spectra(around_);
  for (std::size_t m = 0; m < wave_.size(); ++m) {
    const Wave& w = wave_[m];
    const double* const sums = &orders[2 * (m * rings() + ring)];
    for (std::size_t i = 0; i < count; ++i) {
      const double c = w.own * sums[2 * i], s = w.own * sums[2 * i + 1];
      spectra.of(i)[w.frequency] += Complex(c * w.p + s * w.q, c * w.r - s * w.t);
    }
  }
  for (std::size_t i = 0; i < count; ++i) from_spectrum(spectra.of(i), around_, &map[(ring + i) * around_]);
}

void SphereTransform::to_orders(std::span<const double> map, std::span<const double> weights, std::size_t ring,
                                Orders& orders) const {
  const std::size_t count = std::min(kAtOnce, rings() - ring);
  Spectra spectra(around_);
  for (std::size_t i = 0; i < count; ++i) to_spectrum(&map[(ring + i) * around_], around_, spectra.of(i));
  for (std::size_t m = 0; m < wave_.size(); ++m) {
    const Wave& w = wave_[m];
    double* const sums = &orders[2 * (m * rings() + ring)];
    for (std::size_t i = 0; i < count; ++i) {
      const Complex wave = weights[ring + i] * spectra.of(i)[w.frequency];
      sums[2 * i] = wave.real() * w.p + wave.imag() * w.r;
      sums[2 * i + 1] = wave.real() * w.q - wave.imag() * w.t;
    }
  }
}

void SphereTransform::synthesis(std::span<const double> coefficients, std::span<double> map, const ForEach& run) const {
  require_size("SphereTransform: coefficients", std::ssize(coefficients), coefficient_count(degree()));
  require_size("SphereTransform: map", std::ssize(map), static_cast<long>(rings()) * around_);
  Orders orders(2 * rings() * wave_.size());
  run(tasks(wave_.size()), [&](int task) {
    OfOrders of(kAtOnce * task, degree());
    of.each([&](int l, int m, double* pair) {
      pair[0] = factor(m) * coefficients[coefficient_index(l, m)];
      pair[1] = m == 0 ? 0.0 : factor(m) * coefficients[coefficient_index(l, -m)];
    });
    for (int m = of.first; m <= of.last; ++m) {
      rings_.synthesis(degree(), m, of.pairs(m), std::span(orders).subspan(2 * rings() * m, 2 * rings()));
    }
  });
  run(tasks(rings()), [&](int task) { to_map(orders, kAtOnce * task, map); });
}

void SphereTransform::analysis(std::span<const double> map, std::span<const double> weights,
                               std::span<double> coefficients, const ForEach& run) const {
  require_size("SphereTransform: map", std::ssize(map), static_cast<long>(rings()) * around_);
  require_size("SphereTransform: weights", std::ssize(weights), static_cast<long>(rings()));
  require_size("SphereTransform: coefficients", std::ssize(coefficients), coefficient_count(degree()));
  Orders orders(2 * rings() * wave_.size());
  run(tasks(rings()), [&](int task) { to_orders(map, weights, kAtOnce * task, orders); });
  run(tasks(wave_.size()), [&](int task) {
    OfOrders of(kAtOnce * task, degree());
    for (int m = of.first; m <= of.last; ++m) {
      rings_.analysis(degree(), m, std::span(orders).subspan(2 * rings() * m, 2 * rings()), of.pairs(m));
    }
    of.each([&](int l, int m, const double* pair) {
      if (m > 0) coefficients[coefficient_index(l, -m)] = factor(m) * pair[1];
      coefficients[coefficient_index(l, m)] = factor(m) * pair[0];
    });
  });
}

}  // namespace sh::numeric
