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

// W XYZ RSTUV KLMNOPQ of [Malham03], table 1.
int wxyz(int /*degree*/, int l, int m) {
  constexpr int kPlaces[] = {0, 2, 3, 1, 8, 6, 4, 5, 7, 15, 13, 11, 9, 10, 12, 14};
  return kPlaces[l * l + l + m];
}

double furse_malham(int l, int m, const Vector3& d) {
  const auto [x, y, z] = d;
  const double third = std::sqrt(135.0 / 256) * (5 * z * z - 1);
  const double fifth = std::sqrt(27.0 / 4);
  const double values[] = {std::sqrt(0.5),
                           x,
                           y,
                           z,
                           (3 * z * z - 1) / 2,
                           2 * x * z,
                           2 * y * z,
                           x * x - y * y,
                           2 * x * y,
                           z * (5 * z * z - 3) / 2,
                           third * x,
                           third * y,
                           fifth * z * (x * x - y * y),
                           2 * fifth * x * y * z,
                           x * (x * x - 3 * y * y),
                           y * (3 * x * x - y * y)};
  return values[wxyz(3, l, m)];
}

// y is polar: band 1 is (x, y, z).
Definition e3nn(const std::string& preset, double (*function)(int, int, const Vector3&)) {
  return {.preset = preset,
          .function =
              [=](int l, int m, const Vector3& d) {
                return function(l, m, {d[2], d[0], d[1]});
              },
          .place = acn,
          .size = squared,
          .own_axes = true};
}

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
      {"ambix-w1", schmidt, acn, squared},
      {.preset = "fuma", .function = furse_malham, .place = wxyz, .size = squared, .largest = 3},
      e3nn("e3nn-component", four_pi),
      e3nn("e3nn-integral", own_function),
      e3nn("e3nn-norm", schmidt),
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
