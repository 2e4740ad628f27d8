// Legendre transforms over many rings at once: the inner half of a spherical harmonic transform at high degree.
//
// Synthesis at order m: F(ring) = sum over l of a_l P_lm(ring), l = m .. degree; analysis is its transpose,
// a_l = sum over rings of F(ring) P_lm(ring). P_lm as in legendre_values.hpp: orthonormal, no Condon-Shortley phase.
// Every ring carries two values and every degree two coefficients that share P_lm: those of Y_lm and of Y_(l,-m), or a
// real and an imaginary part. Quadrature weights are the caller's.
//
// SIMD lanes run across rings, the instruction set is chosen when the program runs. The recurrence goes two degrees a
// step [Ishioka18]; next to the poles and the equator, where that loses digits like 1 / sine and 1 / z, in a form
// anchored there (rings/call.hpp). Rings at z and -z cost one recurrence. Values below the smallest double count as 0;
// none are left out otherwise.
//
// Error in double against long double at degree 1000, worst of rings and orders, in units of
// sqrt(sum of a_l^2 (2l+1) / 4 pi): 3e-15 for rings on the circle; 4e-14 where rounding puts z and sine 1e-16 off it,
// since the oracle's r^l is not followed there. Time at degree 1000, 1001 rings, one core with AVX-512: 0.039 ns a
// degree, order and ring, two thirds of ducc's beside it (tests/bench).
#pragma once

#include <span>
#include <vector>

namespace sh::numeric {

namespace rings {
struct Pairs;
}

/// Instruction sets that the transforms are compiled for.
enum class RingLanes { kBaseline, kAvx2, kAvx512 };
/// Whether this machine has it.
bool available(RingLanes lanes) noexcept;
/// The widest that it has.
RingLanes widest_ring_lanes() noexcept;

class LegendreRings {
 public:
  static constexpr int kMaxDegree = 100'000;

  /// Rings at z, sine (n each), in any order. Throws std::invalid_argument if max_degree is not 0 to kMaxDegree, if the
  /// arrays differ in length or lanes are not available, or a ring is not finite, has a negative sine or is off the
  /// circle z^2 + sine^2 = 1 by more than 16 epsilon. Memory: (64 + max_degree / 64) * 16 bytes a pair of rings.
  LegendreRings(int max_degree, std::span<const double> z, std::span<const double> sine,
                RingLanes lanes = widest_ring_lanes());

  [[nodiscard]] int max_degree() const { return max_degree_; }
  [[nodiscard]] std::size_t rings() const { return ring_.size(); }

  /// values (rings, 2) from coefficients (degree - order + 1, 2), degree l at l - order. Throws std::invalid_argument
  /// unless 0 <= order <= degree <= max_degree and the spans have these sizes. Safe to call from several threads at
  /// once.
  void synthesis(int degree, int order, std::span<const double> coefficients, std::span<double> values) const;

  /// coefficients (degree - order + 1, 2) from values (rings, 2); as synthesis.
  void analysis(int degree, int order, std::span<const double> values, std::span<double> coefficients) const;

 private:
  struct Work;
  struct Ring {
    std::size_t pair;
    bool south;  // z < 0
  };

  void check(const char* what, int degree, int order, std::size_t coefficients, std::size_t values) const;
  void add_pairs(std::span<const double> z, std::span<const double> sine);
  void add_powers();
  [[nodiscard]] std::size_t first_pair(int degree, int order) const;
  [[nodiscard]] rings::Pairs pairs(int degree, int order) const;

  int max_degree_;
  RingLanes lanes_;
  std::vector<Ring> ring_;            // (rings)
  std::vector<double> z_, sine_;      // (pairs, padded)
  std::vector<double> log_sine_;      // (pairs, padded), to base 2
  std::vector<double> low_mantissa_;  // (64, pairs): sine^j
  std::vector<double> low_exponent_;
  std::vector<double> high_mantissa_;  // (max_degree / 64 + 1, pairs): sine^(64 j)
  std::vector<double> high_exponent_;
  std::vector<double> sectoral_;  // (max_degree + 1): P_mm / sine^m
};

}  // namespace sh::numeric
