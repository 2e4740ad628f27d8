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

// Rings or orders of one task: their numbers share a line of the cache.
constexpr std::size_t kAtOnce = 4;

// Values of several rings, one a lane: Eigen transforms them all like one. Two lanes fill a register of any machine.
class Lanes {
 public:
#if defined(__AVX__)
  static constexpr std::size_t kCount = 4;
#else
  static constexpr std::size_t kCount = 2;
#endif
  Lanes() = default;
  Lanes(double value) : values_(value - Vector{}) {}  // NOLINT(google-explicit-constructor): a number
  // value(lane) in every lane.
  template <class F>
  static Lanes of(const F& value) {
    Lanes lanes;
    for (std::size_t i = 0; i < kCount; ++i) lanes.values_[i] = value(i);
    return lanes;
  }
  double operator[](std::size_t lane) const { return values_[lane]; }

  friend Lanes operator+(const Lanes& a, const Lanes& b) { return from(a.values_ + b.values_); }
  friend Lanes operator-(const Lanes& a, const Lanes& b) { return from(a.values_ - b.values_); }
  friend Lanes operator*(const Lanes& a, const Lanes& b) { return from(a.values_ * b.values_); }
  friend Lanes operator/(const Lanes& a, const Lanes& b) { return from(a.values_ / b.values_); }
  friend Lanes operator-(const Lanes& a) { return from(-a.values_); }
  Lanes& operator+=(const Lanes& b) { return *this = *this + b; }
  Lanes& operator-=(const Lanes& b) { return *this = *this - b; }
  Lanes& operator*=(const Lanes& b) { return *this = *this * b; }

  // Of Eigen's twiddle factors, which are alike in all lanes.
  friend Lanes acos(const Lanes& a) { return std::acos(a[0]); }
  friend std::complex<Lanes> exp(const std::complex<Lanes>& z) {
    const std::complex<double> e = std::exp(std::complex<double>(z.real()[0], z.imag()[0]));
    return {e.real(), e.imag()};
  }

 private:
  using Vector = double __attribute__((vector_size(kCount * sizeof(double))));
  static Lanes from(const Vector& values) {
    Lanes lanes;
    lanes.values_ = values;
    return lanes;
  }

  Vector values_{};
};
static_assert(kAtOnce % Lanes::kCount == 0);

using Complex = std::complex<Lanes>;

// Spectra of real rings without the half that is conjugate, and no factor 1 / n; plans stay from one call to the next.
Eigen::FFT<Lanes>& fourier() {
  thread_local Eigen::FFT<Lanes> transform = [] {
    Eigen::FFT<Lanes> made;
    made.SetFlag(Eigen::FFT<Lanes>::HalfSpectrum);
    made.SetFlag(Eigen::FFT<Lanes>::Unscaled);
    return made;
  }();
  return transform;
}

// The rings of one task, as many as there are lanes at once.
class TaskRings {
 public:
  explicit TaskRings(int around)
      : around_(around), spectrum_(static_cast<std::size_t>(around) / 2 + 1), values_(around) {}

  [[nodiscard]] Complex& at(int frequency) { return spectrum_[frequency]; }
  void clear() { std::fill(spectrum_.begin(), spectrum_.end(), Complex(0.0)); }

  // One value is its own spectrum; Eigen 3.4 writes to a null pointer there.
  void to_spectrum(const double* rings, std::size_t count) {
    const std::size_t last = std::min(count, Lanes::kCount) - 1;
    for (int j = 0; j < around_; ++j) {
      values_[j] = Lanes::of([&](std::size_t i) { return rings[std::min(i, last) * around_ + j]; });
    }
    if (around_ == 1) {
      spectrum_[0] = values_[0];
    } else {
      fourier().fwd(spectrum_.data(), values_.data(), around_);
    }
  }
  void from_spectrum(double* rings, std::size_t count) {
    if (around_ == 1) {
      values_[0] = spectrum_[0].real();
    } else {
      fourier().inv(values_.data(), spectrum_.data(), around_);
    }
    for (std::size_t i = 0; i < std::min(count, Lanes::kCount); ++i) {
      for (int j = 0; j < around_; ++j) rings[i * around_ + j] = values_[j][i];
    }
  }

 private:
  int around_;
  std::vector<Complex> spectrum_;
  std::vector<Lanes> values_;
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
  TaskRings of(around_);
  for (std::size_t first = 0; first < count; first += Lanes::kCount) {
    of.clear();
    for (std::size_t m = 0; m < wave_.size(); ++m) {
      const Wave& w = wave_[m];
      const double* const sums = &orders[2 * (m * rings() + ring + first)];
      const Lanes c = Lanes::of([&](std::size_t i) { return w.own * sums[2 * i]; });
      const Lanes s = Lanes::of([&](std::size_t i) { return w.own * sums[2 * i + 1]; });
      of.at(w.frequency) += Complex(c * w.p + s * w.q, c * w.r - s * w.t);
    }
    of.from_spectrum(&map[(ring + first) * around_], count - first);
  }
}

void SphereTransform::to_orders(std::span<const double> map, std::span<const double> weights, std::size_t ring,
                                Orders& orders) const {
  const std::size_t count = std::min(kAtOnce, rings() - ring);
  TaskRings of(around_);
  for (std::size_t first = 0; first < count; first += Lanes::kCount) {
    const std::size_t here = std::min(count - first, Lanes::kCount);
    const Lanes weight = Lanes::of([&](std::size_t i) { return i < here ? weights[ring + first + i] : 0.0; });
    of.to_spectrum(&map[(ring + first) * around_], here);
    for (std::size_t m = 0; m < wave_.size(); ++m) {
      const Wave& w = wave_[m];
      const Lanes& real = of.at(w.frequency).real();
      const Lanes& imaginary = of.at(w.frequency).imag();
      const Lanes c = weight * (real * w.p + imaginary * w.r), s = weight * (real * w.q - imaginary * w.t);
      double* const sums = &orders[2 * (m * rings() + ring + first)];
      const auto keep = [&](std::size_t lanes) {
        for (std::size_t i = 0; i < lanes; ++i) {
          sums[2 * i] = c[i];
          sums[2 * i + 1] = s[i];
        }
      };
      // For a number that it does not know, clang would take the lanes from memory.
      here == Lanes::kCount ? keep(Lanes::kCount) : keep(here);
    }
  }
}

void SphereTransform::synthesis(std::span<const double> coefficients, std::span<double> map, const ForEach& run) const {
  require_size("SphereTransform: coefficients", std::ssize(coefficients), coefficient_count(degree()));
  require_size("SphereTransform: map", std::ssize(map), static_cast<long>(rings()) * around_);
  Orders orders(2 * (rings() * wave_.size() + Lanes::kCount));  // some more for lanes without a ring
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
