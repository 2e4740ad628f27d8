// A typical first implementation of the basis: every value from its own associated Legendre recurrence,
// factorials and an angle (Green 2003, "Spherical Harmonics").
#pragma once

#include <cmath>
#include <numbers>

namespace sh::textbook {

inline double factorial(int n) { return n < 2 ? 1.0 : n * factorial(n - 1); }

/// Associated Legendre function without the Condon-Shortley phase, l >= m >= 0, |z| <= 1. Green 2003, recurrences 1-3.
inline double legendre(int l, int m, double z) {
  double diagonal = 1;
  const double sine = std::sqrt((1 - z) * (1 + z));
  for (int i = 1; i <= m; ++i) diagonal *= (2 * i - 1) * sine;
  if (l == m) return diagonal;
  double previous = diagonal;
  double current = z * (2 * m + 1) * diagonal;
  for (int i = m + 2; i <= l; ++i) {
    const double next = ((2 * i - 1) * z * current - (i + m - 1) * previous) / (i - m);
    previous = current;
    current = next;
  }
  return current;
}

inline double textbook_value(int l, int m, double z, double phi) {
  const int order = m < 0 ? -m : m;
  const double scale = std::sqrt((2 * l + 1) / (4 * std::numbers::pi) * factorial(l - order) / factorial(l + order));
  const double value = scale * legendre(l, order, z);
  if (m == 0) return value;
  return std::numbers::sqrt2 * value * (m > 0 ? std::cos(order * phi) : std::sin(order * phi));
}

/// In double inside, whatever T is.
template <class T>
void textbook_basis(int degree, T x, T y, T z, T* out) {
  const double phi = std::atan2(static_cast<double>(y), static_cast<double>(x));
  for (int l = 0; l <= degree; ++l) {
    for (int m = -l; m <= l; ++m) {
      out[l * (l + 1) + m] = static_cast<T>(textbook_value(l, m, static_cast<double>(z), phi));
    }
  }
}

}  // namespace sh::textbook
