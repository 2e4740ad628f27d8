// Spherical harmonic transforms of high degree: from coefficients to a map on rings of equidistant longitudes, and back.
//
// A map holds `around` values on each ring, at phi_j = phi_0 + 2 pi j / around. The Legendre functions of an order meet all
// rings at once (legendre_rings.hpp), and each ring takes one Fourier transform (Eigen's, which is kissfft): of order
// degree^3 and degree^2 log(degree) operations, the latter where `around` has no large prime factor. Coefficients as
// everywhere, at index l(l+1) + m (numeric/README.md).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "numeric/oracle/legendre_rings.hpp"

namespace sh::numeric {

/// Runs task(0) .. task(count - 1), in any order, on as many threads as it likes; the results do not depend on either.
using ForEach = std::function<void(int count, const std::function<void(int)>& task)>;
/// One after the other.
void one_by_one(int count, const std::function<void(int)>& task);

/// The least multiple of 4 from `least` on without other prime factors than 2, 3 and 5: the fastest for `around`.
int smooth_around(int least);

class SphereTransform {
 public:
  /// Rings at z, sine (n each), in any order. Throws std::invalid_argument like LegendreRings, and unless around is 1 or
  /// more and phi_0 finite. A ring that is too coarse for an order shows it as a lower one (aliasing), as any sampling
  /// does; none does where around > 2 degree.
  SphereTransform(int degree, std::span<const double> z, std::span<const double> sine, int around, double phi_0 = 0,
                  RingLanes lanes = widest_ring_lanes());

  [[nodiscard]] int degree() const { return rings_.max_degree(); }
  [[nodiscard]] std::size_t rings() const { return rings_.rings(); }
  [[nodiscard]] int around() const { return around_; }

  /// map (rings, around): values of the function with coefficients (bands^2). Throws std::invalid_argument for spans of
  /// another size. Memory: 16 bytes a ring and order.
  void synthesis(std::span<const double> coefficients, std::span<double> map, const ForEach& run = one_by_one) const;

  /// coefficients (bands^2): for every Y_i the sum over the map of weight[ring] map Y_i. They are the function's where the
  /// map has no higher bands than degree and weights (rings) times 2 pi / around make a quadrature that is exact for
  /// twice that, as Gauss-Legendre weights and around > 2 degree do.
  void analysis(std::span<const double> map, std::span<const double> weights, std::span<double> coefficients,
                const ForEach& run = one_by_one) const;

 private:
  // (orders, rings, 2): the factors of the cosine and the sine of each order.
  using Orders = std::vector<double>;
  // c cos(m phi) + s sin(m phi) at phi_0 + x is the real part of ((c p + s q) + i (c r - s t)) e^(i f x), f a frequency
  // that a ring tells apart.
  struct Wave {
    int frequency;
    double p, q, r, t;
    double own;  // 1 where the frequency is its own conjugate, else 0.5: its part of a spectrum of real values
  };
  void to_map(const Orders& orders, std::size_t ring, std::span<double> map) const;
  void to_orders(std::span<const double> map, std::span<const double> weights, std::size_t ring, Orders& orders) const;

  LegendreRings rings_;
  int around_;
  std::vector<Wave> wave_;  // (degree + 1)
};

}  // namespace sh::numeric
