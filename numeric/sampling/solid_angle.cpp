// Solid angles of pixels: solid_angle.hpp.
#include "numeric/sampling/solid_angle.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/oracle/real.hpp"

namespace sh::numeric {

template <class Real>
Real texel_solid_angle(const Real& u, const Real& v, int size) {
  using std::atan2;
  using std::sqrt;
  const Real h = 1 / static_cast<Real>(size);
  const Real left = u - h;
  const Real right = u + h;
  const Real low = v - h;
  const Real high = v + h;
  const auto length = [](const Real& a, const Real& b) { return Real(sqrt(Real(1 + a * a + b * b))); };
  const Real start = length(left, low);
  const Real end = length(right, high);
  const Real diagonal = 1 + left * right + low * high;  // start . end
  // The triangle start, (a, b), end: |s||c||e| + (s.c)|e| + (c.e)|s| + (e.s)|c|.
  const auto half_of_triangle = [&](const Real& a, const Real& b) {
    const Real corner = length(a, b);
    const Real from_start = 1 + left * a + low * b;
    const Real to_end = 1 + right * a + high * b;
    const Real denominator = start * corner * end + from_start * end + to_end * start + diagonal * corner;
    return Real(atan2(Real(4 * h * h), denominator));
  };
  return 2 * (half_of_triangle(right, low) + half_of_triangle(left, high));
}

template <class Real>
Real texel_solid_angle_estimate(const Real& u, const Real& v, int size) {
  using std::sqrt;
  const Real square = 1 + u * u + v * v;
  return 4 / (static_cast<Real>(size) * static_cast<Real>(size) * square * Real(sqrt(square)));
}

template <class Real>
Real lat_long_solid_angle(int row, int width, int height) {
  using std::sin;
  const Real half = pi<Real>() / (2 * static_cast<Real>(height));
  const Real from_pole = static_cast<Real>(std::min(row, height - 1 - row));
  return 4 * pi<Real>() / static_cast<Real>(width) * Real(sin(Real((2 * from_pole + 1) * half))) * Real(sin(half));
}

#define SHFORGE_INSTANCE(Real)                                                   \
  template Real texel_solid_angle<Real>(const Real&, const Real&, int);          \
  template Real texel_solid_angle_estimate<Real>(const Real&, const Real&, int); \
  template Real lat_long_solid_angle<Real>(int, int, int);

SHFORGE_INSTANCE(double)
SHFORGE_INSTANCE(Mpfr50)

}  // namespace sh::numeric
