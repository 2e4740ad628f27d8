#include "tests/codegen/convention_definitions.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <stdexcept>

namespace sh::codegen::test {
namespace {

// P_l^a(cos theta) cos(a phi), or sin(a phi) for m < 0.
double unnormalized(int l, int m, const Vector3& d) {
  const auto a = static_cast<unsigned>(std::abs(m));
  const double phi = std::atan2(d[1], d[0]);
  const double legendre = std::assoc_legendre(static_cast<unsigned>(l), a, d[2]);
  return legendre * (m < 0 ? std::sin(a * phi) : std::cos(a * phi));
}

// (2 - delta) (l-a)! / (l+a)!
double schmidt_square(int l, int m) {
  const int a = std::abs(m);
  double square = a == 0 ? 1 : 2;
  for (int k = l - a + 1; k <= l + a; ++k) square /= k;
  return square;
}

double schmidt(int l, int m, const Vector3& d) { return std::sqrt(schmidt_square(l, m)) * unnormalized(l, m, d); }

double four_pi(int l, int m, const Vector3& d) { return std::sqrt(2 * l + 1) * schmidt(l, m, d); }

double with_phase(int l, int m, const Vector3& d) { return (m % 2 == 0 ? 1 : -1) * own_function(l, m, d); }

// SHMath.cginc of Unity and the shaders of Filament: 1, y, z, x, xy, yz, 3z^2-1, xz, x^2-y^2.
double polynomial(int l, int m, const Vector3& d) {
  const auto [x, y, z] = d;
  const double values[] = {1, y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y};
  return values[l * l + l + m];
}

int acn(int /*degree*/, int l, int m) { return l * l + l + m; }
int squared(int degree) { return (degree + 1) * (degree + 1); }

// cilm[m < 0][l][|m|], two squares of numbers
int cilm(int degree, int l, int m) { return ((m < 0 ? degree + 1 : 0) + l) * (degree + 1) + std::abs(m); }
int two_squares(int degree) { return 2 * squared(degree); }

std::vector<Definition> all_definitions() {
  return {
      {"shforge", own_function, acn, squared},
      {"directxmath", with_phase, acn, squared},
      {"threejs", own_function, acn, squared},
      {.preset = "unity", .function = polynomial, .place = acn, .size = squared, .convolved = true, .largest = 2},
      {"unreal", with_phase, acn, squared},
      {.preset = "filament", .function = polynomial, .place = acn, .size = squared, .convolved = true, .largest = 2},
      {"gaussian-splatting", with_phase, acn, squared},
      {"ambix", [](int l, int m, const Vector3& d) { return schmidt(l, m, d) / std::sqrt(4 * std::numbers::pi); }, acn,
       squared},
      {"shtools", four_pi, cilm, two_squares}};
}

}  // namespace

double dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

const std::vector<Definition>& definitions() {
  static const std::vector<Definition> all = all_definitions();
  return all;
}

const Definition& definition_of(const std::string& preset) {
  for (const Definition& definition : definitions()) {
    if (definition.preset == preset) return definition;
  }
  throw std::invalid_argument(preset + ": expected a formula of this convention, got none");
}

double own_function(int l, int m, const Vector3& d) { return four_pi(l, m, d) / std::sqrt(4 * std::numbers::pi); }

Vector3 named_coordinates(std::string_view axes, const Vector3& d) {
  Vector3 result{};
  double sign = 1;
  std::size_t row = 0;
  for (const char c : axes) {
    if (c == '-') sign = -1;
    if (c < 'x' || c > 'z') continue;
    result.at(row++) = sign * d[static_cast<std::size_t>(c - 'x')];
    sign = 1;
  }
  return result;
}

}  // namespace sh::codegen::test
