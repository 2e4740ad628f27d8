// Reference values of spherical harmonics, Legendre functions and caps, in decimal, with as many correct digits as
// asked for (decimal.hpp).
//
// Input: degree, order, a direction or a colatitude in decimals taken exactly ([+-]digits[.digits][e[+-]digits]),
// digits. Output: the value in scientific notation, such as "-3.14e-01"; "0" where it is exactly zero: where the
// polynomial vanishes modulo four primes near 2^31 (were it not zero, the odds against that are above 10^20).
// Conventions: README.md. All throw std::invalid_argument, one line, for a malformed number, the zero vector, a number
// outside its domain, and for a degree, order or digits out of range.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace sh::numeric {

constexpr int kMaxReferenceDegree = 10000;

/// Y_(degree, order) at direction / |direction|.
std::string reference_value(int degree, int order, const std::array<std::string, 3>& direction, int digits);

/// d/dx, d/dy, d/dz of the homogeneous form r^l Y_lm(d / r) at direction / |direction|.
std::array<std::string, 3> reference_gradient(int degree, int order, const std::array<std::string, 3>& direction,
                                              int digits);

/// A colatitude or half-angle as the user gives it.
struct Colatitude {
  enum class Kind {
    kCosine,       // z, -1 .. 1
    kAngle,        // radians, 0 .. pi
    kOneMinusCos,  // 0 .. 2
  };
  Kind kind;
  std::string name;  // begins a refusal: "--z"
  std::string text;
};

/// The orthonormal P_lm(cos theta) = sin^m theta Q_lm, m >= 0: Y_l0 = P_l0, Y_lm = sqrt 2 P_lm cos(m phi).
std::string legendre_reference(int degree, int order, const Colatitude& colatitude, int digits);

/// The coefficient of Y_l0 of the function that is 1 in the cap of this half-angle about +z, 0 outside:
/// 2 pi sin(theta) P_l1(cos theta) / sqrt(l (l+1)), for l = 0 sqrt(pi) (1 - cos theta).
std::string cap_reference(int degree, const Colatitude& half_angle, int digits);

/// A positive multiple of Q_lm at z and u2 = 1 - z^2, integers modulo a prime below 2^31: with R_l = 1 and
///   R_(m-1) = 2 m z R_m - (l+m+1)(l-m) u2 R_(m+1),
/// the recurrence of legendre.hpp freed of its roots and quotients.
std::uint64_t reduced_legendre_modulo(std::uint64_t prime, int degree, int order, std::uint64_t z, std::uint64_t u2);

/// Whether vanishes(prime) for four primes near 2^31.
template <class Vanishes>
bool vanishes_modulo_primes(const Vanishes& vanishes) {
  for (const std::uint64_t prime : {2147483647U, 2147483629U, 2147483587U, 2147483579U}) {
    if (!vanishes(prime)) return false;
  }
  return true;
}

}  // namespace sh::numeric
