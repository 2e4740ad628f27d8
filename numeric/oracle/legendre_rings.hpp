// Legendre transforms over many rings at once: the inner half of a spherical harmonic transform at high degree.
//
// Synthesis at order m: F(ring) = sum over l of a_l P_lm(ring), l = m .. degree; analysis is its transpose,
// a_l = sum over rings of F(ring) P_lm(ring). P_lm as in legendre_values.hpp: orthonormal, no Condon-Shortley phase.
// Every ring carries two values and every degree two coefficients that share P_lm: those of Y_lm and of Y_(l,-m), or a
// real and an imaginary part. Quadrature weights are the caller's.
//
// SIMD lanes run across rings, the instruction set is chosen when the program runs. The recurrence goes two degrees a
// step [Ishioka18]; next to the poles and the equator, where that loses digits like 1 / sine and 1 / z, in a form
// anchored there (rings/call.hpp). Rings at z and -z cost one recurrence.
//
// Error in double against long double at degree 1000, worst of rings and orders, in units of
// sqrt(sum of a_l^2 (2l+1) / 4 pi): 3e-15 for rings on the circle; 4e-14 where rounding puts z and sine 1e-16 off it,
// since the oracle's r^l is not followed there. Times beside another library: `build/bin/targets_bench legendre`.
#pragma once

#include <memory>
#include <span>
#include <vector>

namespace sh::numeric {

namespace rings {
struct Pairs;
struct Tables;
}  // namespace rings

/// Instruction sets that the transforms are compiled for.
enum class RingLanes { kBaseline, kAvx2, kAvx512 };
/// Whether this machine has it.
bool available(RingLanes lanes) noexcept;
/// The widest that it has.
RingLanes widest_ring_lanes() noexcept;

/// Which values of P_lm count: all doubles, or those that can matter beside others, which is faster at high degree. The
/// latter leaves out some below 2^-384 (4m + 8)^8, at most 1e-71; all from there on count.
enum class RingTail { kNegligible, kAll };

class LegendreRings {
 public:
  static constexpr int kMaxDegree = 100'000;

  /// Rings at z, sine (n each), in any order. Throws std::invalid_argument if max_degree is not 0 to kMaxDegree, if the
  /// arrays differ in length or lanes are not available, or a ring is not finite, has a negative sine or is off the
  /// circle z^2 + sine^2 = 1 by more than 16 epsilon. Memory: (64 + max_degree / 64) * 16 bytes a pair of rings; to degree
  /// 200 also 36 bytes for each degree and order.
  LegendreRings(int max_degree, std::span<const double> z, std::span<const double> sine,
                RingLanes lanes = widest_ring_lanes(), RingTail tail = RingTail::kNegligible);

  [[nodiscard]] int max_degree() const { return max_degree_; }
  [[nodiscard]] std::size_t rings() const { return place_.size(); }

  /// values (rings, 2) from coefficients (degree - order + 1, 2), degree l at l - order. Throws std::invalid_argument
  /// unless 0 <= order <= degree <= max_degree and the spans have these sizes. Safe to call from several threads at
  /// once.
  void synthesis(int degree, int order, std::span<const double> coefficients, std::span<double> values) const;

  /// coefficients (degree - order + 1, 2) from values (rings, 2); as synthesis.
  void analysis(int degree, int order, std::span<const double> values, std::span<double> coefficients) const;

 private:
  struct Work;

  void check(const char* what, int degree, int order, std::size_t coefficients, std::size_t values) const;
  void add_pairs(std::span<const double> z, std::span<const double> sine);
  void add_powers();
  [[nodiscard]] std::size_t first_pair(int degree, int order) const;
  [[nodiscard]] rings::Pairs pairs(int degree, int order) const;
  void fill(int order, const rings::Tables& tables) const;

  int max_degree_;
  RingLanes lanes_;
  RingTail tail_;
  std::vector<std::size_t> place_;    // (rings), in values of pairs: 4 pair, and 2 where z < 0
  std::vector<double> z_, sine_;      // (pairs, padded)
  std::vector<double> log_sine_;      // (pairs, padded), to base 2
  std::vector<double> low_mantissa_;  // (64, pairs): sine^j
  std::vector<double> low_exponent_;
  std::vector<double> high_mantissa_;  // (max_degree / 64 + 1, pairs): sine^(64 j)
  std::vector<double> high_exponent_;
  std::vector<double> log_factorial_;    // (2 max_degree + 1), to base 2
  std::vector<double> sectoral_;         // (max_degree + 1): P_mm / sine^m
  std::size_t plain_ = 0, equator_ = 0;  // where pairs start that are not anchored at the pole, that are at the equator
  std::vector<std::unique_ptr<double[]>> kept_tables_;  // by order, to a small max_degree
};

}  // namespace sh::numeric
