// [SloanKautzSnyder02] section 5 and eq. 12, the transport simulation and glossy exit radiance: S-24 to S-30.
//
// The update rules are run over sets of directions whose sums are known exactly: the six axes (exact for degree 3), and
// rings at equal steps of z (the midpoint rule on either hemisphere, exact there for degree 1 in z).
#include <cln/integer.h>

#include <array>

#include "symbolic/errata/parts.hpp"
#include "symbolic/errata/sphere_function.hpp"
#include "symbolic/rotation/rotation_input.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_RA;
using sphere::SphereFunction;

using Direction = std::array<RadicalSum, 3>;

cl_RA fraction(int numerator, int denominator) { return cl_RA(numerator) / denominator; }

int bins(int faces, int levels) { return faces << levels; }
bool bins_of_an_icosahedron() { return bins(20, 6) == 512 && bins(20, 8) == 2048; }

RadicalSum dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Direction cross(const Direction& a, const Direction& b) {
  Direction result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    result[i] = a[j] * b[k] - a[k] * b[j];
  }
  return result;
}

// tan(area/2) = a.(b x c) / (1 + a.b + b.c + c.a) of counter-clockwise triangles, compared crosswise.
using Triangle = std::array<Direction, 3>;
bool equal_areas(const Triangle& s, const Triangle& t) {
  const auto numerator = [](const Triangle& u) { return dot(u[0], cross(u[1], u[2])); };
  const auto denominator = [](const Triangle& u) {
    return RadicalSum(1) + dot(u[0], u[1]) + dot(u[1], u[2]) + dot(u[2], u[0]);
  };
  return numerator(s) * denominator(t) == numerator(t) * denominator(s);
}

// An octant: halved at the midpoint of an edge, its half halved again, and cut into four at the midpoints.
bool only_the_first_bisection_at_a_midpoint_is_equal() {
  const RadicalSum zero;
  const RadicalSum one(1);
  const RadicalSum h(Surd::square_root(fraction(1, 2)));
  const Direction x{one, zero, zero};
  const Direction y{zero, one, zero};
  const Direction z{zero, zero, one};
  const Direction xy{h, h, zero};
  const Direction yz{zero, h, h};
  const Direction zx{h, zero, h};
  return equal_areas({x, xy, z}, {xy, y, z}) && !equal_areas({x, xy, zx}, {zx, xy, z}) &&
         !equal_areas({x, xy, zx}, {xy, yz, zx});
}
bool bins_of_an_octahedron() {
  return bins(8, 6) == 512 && bins(8, 8) == 2048 && only_the_first_bisection_at_a_midpoint_is_equal();
}

std::vector<Direction> axes() {
  std::vector<Direction> directions;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int sign : {1, -1}) {
      Direction d;
      d[axis] = RadicalSum(sign);
      directions.push_back(d);
    }
  }
  return directions;
}

// z = +-(2k-1)/(2n), four azimuths each.
std::vector<Direction> rings(int n) {
  std::vector<Direction> directions;
  for (int k = 1 - 2 * n; k < 2 * n; k += 2) {
    const cl_RA z = fraction(k, 2 * n);
    const RadicalSum radius(Surd::square_root(1 - z * z));
    directions.push_back({radius, RadicalSum(), RadicalSum(z)});
    directions.push_back({-radius, RadicalSum(), RadicalSum(z)});
    directions.push_back({RadicalSum(), radius, RadicalSum(z)});
    directions.push_back({RadicalSum(), -radius, RadicalSum(z)});
  }
  return directions;
}

// What a rule does with each direction: += term(s_d), as printed or times 4 pi / N_d.
enum class Weight { kNone, kSolidAngle };
template <class Term>
RadicalSum accumulated(const std::vector<Direction>& directions, Weight weight, const Term& term) {
  RadicalSum sum;
  for (const Direction& d : directions) sum += term(d);
  if (weight == Weight::kNone) return sum;
  return RadicalSum(Surd(fraction(4, static_cast<int>(directions.size()))) * Surd::square_root(1, 2)) * sum;
}

RadicalSum cosine(const Direction& d) {  // H for N = z
  return d[2].is_zero() || d[2].surd().is_negative() ? RadicalSum() : d[2];
}
cl_RA albedo() { return fraction(3, 10); }
RadicalSum albedo_over_pi() { return RadicalSum(Surd(albedo()) * Surd::square_root(1, -2)); }

// += (rho/pi) V H y_i with V = 1: coefficient 0 exact, the error of y_10 four times smaller with twice the rings.
bool diffuse_shadow_rule(Weight weight) {
  const SphereFunction y00 = sphere::spherical_harmonic(0, 0);
  const SphereFunction y10 = sphere::spherical_harmonic(1, 0);
  const auto error = [weight](int n, const SphereFunction& y) {
    const auto term = [&y](const Direction& d) { return albedo_over_pi() * cosine(d) * y.at(d); };
    const RadicalSum exact = albedo_over_pi() * sphere::zone_integral(y * SphereFunction::variable(2), 0, 1);
    return accumulated(rings(n), weight, term) - exact;
  };
  return error(1, y00).is_zero() && error(2, y00).is_zero() && !error(1, y10).is_zero() &&
         error(1, y10) == RadicalSum(4) * error(2, y10);
}
bool diffuse_shadow_as_printed() { return diffuse_shadow_rule(Weight::kNone); }
bool diffuse_shadow_weighted() { return diffuse_shadow_rule(Weight::kSolidAngle); }

// += V y_j y_i with V = (3 + z)/4, bands 0 and 1: degree 3 in all.
bool glossy_shadow_rule(Weight weight) {
  const SphereFunction v(Surd(fraction(1, 4)), Polynomial(3) + Polynomial::variable(2));
  const std::vector<SphereFunction> y = sphere::spherical_harmonics(1);
  for (const SphereFunction& row : y) {
    for (const SphereFunction& column : y) {
      const auto term = [&](const Direction& d) { return v.at(d) * column.at(d) * row.at(d); };
      if (!(accumulated(axes(), weight, term) == sphere::sphere_integral(v * row * column))) return false;
    }
  }
  return true;
}
bool glossy_shadow_as_printed() { return glossy_shadow_rule(Weight::kNone); }
bool glossy_shadow_weighted() { return glossy_shadow_rule(Weight::kSolidAngle); }

// += (rho/pi) (1-V) (M_q)_i H where nothing but O is seen, all of it with the same transfer t: the result is rho t.
bool diffuse_bounce_rule(Weight weight) {
  const RadicalSum t(fraction(-7, 4));
  for (const int n : {1, 2, 3}) {
    const auto term = [&t](const Direction& d) { return albedo_over_pi() * t * cosine(d); };
    if (!(accumulated(rings(n), weight, term) == RadicalSum(albedo()) * t)) return false;
  }
  return true;
}
bool diffuse_bounce_as_printed() { return diffuse_bounce_rule(Weight::kNone); }
bool diffuse_bounce_weighted() { return diffuse_bounce_rule(Weight::kSolidAngle); }

// A glossy kernel 1 + 2t + t^2 and its factor for function k: alpha_l G*_l by band, or alpha_l times (G*)_k, the k-th
// coefficient, which is 0 for m != 0.
enum class KernelIndex { kBand, kFunction };
SphereFunction kernel() {
  const Polynomial t = Polynomial::variable(2);
  return SphereFunction(Surd(1), Polynomial(1) + cl_RA(2) * t + t * t);
}
RadicalSum kernel_factor(KernelIndex index, int l, int m) {
  if (index == KernelIndex::kFunction && m != 0) return {};
  const RadicalSum alpha(Surd::square_root(fraction(4, 2 * l + 1), 1));
  return alpha * sphere::zone_integral(kernel() * sphere::zonal_harmonic(l), -1, 1);
}

// sum_k alpha_k G*_k c_k y_k, a function of the reflected direction.
SphereFunction glossy_sum(KernelIndex index, const std::vector<RadicalSum>& c) {
  std::vector<RadicalSum> scaled;
  for (int l = 0; scaled.size() < c.size(); ++l) {
    for (int m = -l; m <= l; ++m) scaled.push_back(kernel_factor(index, l, m) * c[scaled.size()]);
  }
  return sphere::expansion(scaled);
}

std::array<cl_RA, 3> normal() { return {fraction(2, 3), fraction(-1, 3), fraction(2, 3)}; }

// reflect(-s, N) = 2 (N.(-s)) N + s
Matrix<cl_RA> reflection() {
  const std::array<cl_RA, 3> n = normal();
  Matrix<cl_RA> m = Matrix<cl_RA>::identity(3, 1);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m(i, j) = m(i, j) - 2 * n[to_size(i)] * n[to_size(j)];
  }
  return m;
}

// The same as half a turn of -s about N.
Matrix<cl_RA> half_turn_of_opposite() {
  const auto [x, y, z] = normal();
  Matrix<cl_RA> m = matrix_from_quaternion<cl_RA>({0, x, y, z});
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m(i, j) = -m(i, j);
  }
  return m;
}

// One column j of the rule with V = 0: rows i of INT (incident radiance convolved with G at the reflection) y_i.
bool glossy_bounce_rule(KernelIndex index, Weight weight) {
  const std::vector<RadicalSum> column = sphere::some_coefficients(1, 5);
  const SphereFunction leaving = glossy_sum(index, column).turned(reflection());
  const SphereFunction exact = sphere::convolved(sphere::expansion(column), kernel()).turned(half_turn_of_opposite());
  for (const SphereFunction& y : sphere::spherical_harmonics(1)) {
    const auto term = [&](const Direction& d) { return leaving.at(d) * y.at(d); };
    if (!(accumulated(axes(), weight, term) == sphere::sphere_integral(exact * y))) return false;
  }
  return true;
}
bool glossy_bounce_by_band() { return glossy_bounce_rule(KernelIndex::kBand, Weight::kSolidAngle); }
bool glossy_bounce_by_band_as_printed() { return glossy_bounce_rule(KernelIndex::kBand, Weight::kNone); }
bool glossy_bounce_by_function() { return glossy_bounce_rule(KernelIndex::kFunction, Weight::kSolidAngle); }

SphereFunction visibility() {
  const Polynomial x = Polynomial::variable(0);
  return SphereFunction(Surd(fraction(1, 5)), Polynomial(3) + x - cl_RA(2) * (x * Polynomial::variable(2)));
}

Matrix<RadicalSum> visibility_matrix(int size) {
  const std::vector<SphereFunction> y = sphere::spherical_harmonics(2);
  Matrix<RadicalSum> v(size, size);
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) v(i, j) = sphere::sphere_integral(visibility() * y[to_size(i)] * y[to_size(j)]);
  }
  return v;
}

// A point q with the matrix above, seen by p in every direction: M_ij = INT (G applied to column j, reflected) y_i.
Matrix<RadicalSum> bounce_matrix() {
  const Matrix<RadicalSum> at_q = visibility_matrix(4);
  const std::vector<SphereFunction> y = sphere::spherical_harmonics(1);
  Matrix<RadicalSum> m(4, 4);
  for (int j = 0; j < 4; ++j) {
    const std::vector<RadicalSum> column{at_q(0, j), at_q(1, j), at_q(2, j), at_q(3, j)};
    const SphereFunction leaving = glossy_sum(KernelIndex::kBand, column).turned(reflection());
    for (int i = 0; i < 4; ++i) m(i, j) = sphere::sphere_integral(leaving * y[to_size(i)]);
  }
  return m;
}

bool shadowed_matrix_symmetric_interreflected_not() {
  const Matrix<RadicalSum> shadowed = visibility_matrix(9);
  const Matrix<RadicalSum> interreflected = bounce_matrix();
  return shadowed == shadowed.transposed() && !(interreflected == interreflected.transposed());
}

// sum_i alpha G* (M L)_i y_i(R) against (V L) convolved with the kernel; L of degree 0, so that V L has degree 2.
bool glossy_exit_radiance(KernelIndex index) {
  const Matrix<RadicalSum> m = visibility_matrix(9);
  const std::vector<RadicalSum> light{RadicalSum(fraction(7, 2))};
  std::vector<RadicalSum> transferred(9);
  for (int i = 0; i < 9; ++i) {
    for (std::size_t j = 0; j < light.size(); ++j) transferred[to_size(i)] += m(i, static_cast<int>(j)) * light[j];
  }
  return sphere::equal_on_sphere(glossy_sum(index, transferred),
                                 sphere::convolved(visibility() * sphere::expansion(light), kernel()));
}
bool glossy_exit_by_band() { return glossy_exit_radiance(KernelIndex::kBand); }
bool glossy_exit_by_function() { return glossy_exit_radiance(KernelIndex::kFunction); }

}  // namespace

std::vector<Entry> sloan_simulation() {
  return {
      {"S-24",
       "5, direction bins",
       Kind::kText,
       Print::kRead,
       "an icosahedron, 1->2 bisection into equal areas, 6 to 8 levels, 512 to 2048 bins",
       Verdict::kWrong,
       {{"20 * 2^levels", bins_of_an_icosahedron}},
       "an octahedron: 8 * 2^6 = 512, 8 * 2^8 = 2048",
       bins_of_an_octahedron,
       "An icosahedron gives 1280 to 5120. Bisection at midpoints has equal areas in the first step only; later the "
       "point has to be chosen for it. That 1->4 has unequal areas is right."},
      {"S-25",
       "5, shadow pass, diffuse",
       Kind::kEquation,
       Print::kRead,
       "(M_p)_i^0 += (rho_p/pi) V_p(s_d) H_N(s_d) y_i(s_d)",
       Verdict::kUnderReading,
       {{"the sum as it is", diffuse_shadow_as_printed}, {"times 4 pi/N_d", diffuse_shadow_weighted}},
       "+= (4 pi/N_d) (rho_p/pi) V H y_i",
       nullptr,
       "Here M holds rho/pi, in eq. 10 it does not."},
      {"S-26",
       "5, shadow pass, glossy",
       Kind::kEquation,
       Print::kRead,
       "(M_p)_ij^0 += V_p(s_d) y_j(s_d) y_i(s_d)",
       Verdict::kUnderReading,
       {{"the sum as it is", glossy_shadow_as_printed}, {"times 4 pi/N_d", glossy_shadow_weighted}},
       "+= (4 pi/N_d) V y_j y_i",
       nullptr,
       ""},
      {"S-27",
       "5, interreflection, diffuse",
       Kind::kEquation,
       Print::kRead,
       "(M_p)_i^b += (rho_p/pi) (1-V_p(s_d)) (M_q)_i^{b-1} H_N(s_d)",
       Verdict::kUnderReading,
       {{"the sum as it is", diffuse_bounce_as_printed}, {"times 4 pi/N_d", diffuse_bounce_weighted}},
       "+= (4 pi/N_d) (rho_p/pi) (1-V) M_q H",
       nullptr,
       "M_q is exit radiance and holds rho_q/pi already."},
      {"S-28",
       "5, interreflection, glossy",
       Kind::kEquation,
       Print::kRead,
       "(M_p)_ij^b += (1-V) (sum_k alpha_k (G*_rq)_k (M_q^{b-1})_kj y_k(reflect(-s_d, N_q))) y_i(s_d)",
       Verdict::kUnderReading,
       {{"alpha_k (G*)_k by the band of k, times 4 pi/N_d", glossy_bounce_by_band},
        {"by band, the sum as it is", glossy_bounce_by_band_as_printed},
        {"(G*)_k the k-th coefficient, times 4 pi/N_d", glossy_bounce_by_function}},
       "+= (4 pi/N_d) (1-V) (sum_k alpha_l G*_l^0 (M_q)_kj y_k(reflect(-s_d, N_q))) y_i, l the band of k",
       nullptr,
       "reflect(v, N) = 2 (N.v) N - v. The k-th coefficient of a zonal kernel vanishes for m != 0."},
      {"S-29",
       "5, text on symmetry",
       Kind::kText,
       Print::kRead,
       "the shadowed glossy matrix is symmetric, the interreflected one is not",
       Verdict::kCorrect,
       {{"one visibility function, one bounce off it", shadowed_matrix_symmetric_interreflected_not}},
       "",
       nullptr,
       "The second in general: there are scenes in which it is."},
      {"S-30",
       "Eq. 12",
       Kind::kEquation,
       Print::kRead,
       "sum_{i=1}^{n^2} alpha_i G*_i (sum_{j=1}^{n^2} (M_p)_ij (L_p)_j) y_i(R)",
       Verdict::kUnderReading,
       {{"alpha_i G*_i by the band of i", glossy_exit_by_band}, {"G*_i the i-th coefficient", glossy_exit_by_function}},
       "sum_i alpha_l G*_l^0 (M L)_i y_i(R), l the band of i",
       nullptr,
       "The convolution of M L with G*, eq. 6."},
  };
}

}  // namespace sh::symbolic::errata
