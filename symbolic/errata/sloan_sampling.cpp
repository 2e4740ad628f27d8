// [SloanKautzSnyder02] sections 6.2, 7 and 9, cube maps, volumes, results: S-31 to S-38.
#include <cln/real.h>

#include <array>

#include "symbolic/basis/basis.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/errata/sphere_function.hpp"
#include "symbolic/errata/texel_solid_angle.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_R;
using cln::cl_RA;
using sphere::SphereFunction;

cl_RA fraction(int numerator, int denominator) { return cl_RA(numerator) / denominator; }

// s = p/w, p = (u, v, 1), w^2 = 1+u^2+v^2: w^3 ds/du = w^2 e_u - u p and so for v; their product is w^2 p, so that
// |ds/du x ds/dv| = w^2 |p| / w^6 = w^-3.
bool area_element_of_the_face() {
  const Polynomial u = Polynomial::variable(0);
  const Polynomial v = Polynomial::variable(1);
  const Polynomial one(1);
  const Polynomial w2 = one + u * u + v * v;
  const std::array<Polynomial, 3> p{u, v, one};
  std::array<Polynomial, 3> a;
  std::array<Polynomial, 3> b;
  for (std::size_t i = 0; i < 3; ++i) {
    a[i] = (i == 0 ? w2 : Polynomial()) - u * p[i];
    b[i] = (i == 1 ? w2 : Polynomial()) - v * p[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    if (!(a[j] * b[k] - a[k] * b[j] == w2 * p[i])) return false;
  }
  return true;
}
bool texel_solid_angle() {
  return area_element_of_the_face() && texel::corner_integrates_area_element() &&
         texel::corner_of_face_is_sixth_of_pi();
}

constexpr int kDigits = 40;
constexpr int kFunctions = 36;  // 6 bands

// sum of ds x^a y^b z^c over the texels of six N x N images, ds = 4/N^2 (1+u^2+v^2)^(-3/2) at the centre.
cl_R cube_map_moment(int size, const Monomial& monomial) {
  cl_R sum;
  for (int face = 0; face < 3; ++face) {
    for (const cl_RA& u : texel::texel_centres(size)) {
      for (const cl_RA& v : texel::texel_centres(size)) {
        std::array<cl_RA, 3> p{1, u, v};
        cl_RA product = fraction(4, size * size);
        for (int i = 0; i < 3; ++i) product = product * cln::expt(p[to_size((i + face) % 3)], monomial.exponent(i));
        if (monomial.degree() % 2 != 0) continue;  // cancels against the opposite face
        const cl_RA square = 1 + u * u + v * v;
        const Surd size_of_term =
            Surd(2 * product / cln::expt(square, monomial.degree() / 2 + 2)) * Surd::square_root(square);
        sum = sum + size_of_term.evaluate(kDigits);
      }
    }
  }
  return sum;
}

// sum of ds y_i y_j minus delta_ij.
Matrix<cl_R> projection_error(int size) {
  std::map<Monomial, cl_R> moments;
  std::vector<BasisFunction> basis;
  for (int l = 0; l < 6; ++l) {
    for (int m = -l; m <= l; ++m) basis.push_back(basis_function(l, m));
  }
  Matrix<cl_R> error(kFunctions, kFunctions);
  for (int i = 0; i < kFunctions; ++i) {
    for (int j = 0; j <= i; ++j) {
      const BasisFunction& a = basis[to_size(i)];
      const BasisFunction& b = basis[to_size(j)];
      const Polynomial product = a.homogeneous * b.homogeneous;
      cl_R sum;  // exact 0: takes the precision of the terms
      for (const auto& [monomial, coefficient] : product.terms()) {
        const auto [position, inserted] = moments.try_emplace(monomial);
        if (inserted) position->second = cube_map_moment(size, monomial);
        sum = sum + position->second * coefficient;
      }
      error(i, j) = sum * (a.factor * b.factor).evaluate(kDigits) - (i == j ? 1 : 0);
      error(j, i) = error(i, j);
    }
  }
  return error;
}

cl_R squared_norm(const Matrix<cl_R>& m) {
  cl_R sum;
  for (int i = 0; i < m.rows(); ++i) {
    for (int j = 0; j < m.columns(); ++j) sum = sum + m(i, j) * m(i, j);
  }
  return sum;
}

// Mean squared error |E|^2 / 36, and the worst, s^2 for the largest singular value s of the symmetric E. With
// t_n = trace E^n, (t_16 / t_8)^(1/4) <= s^2 <= t_16^(1/8).
struct ErrorRange {
  cl_R mean;
  cl_R worst_lower;
  cl_R worst_upper;
};
ErrorRange squared_errors(int size) {
  const Matrix<cl_R> e = projection_error(size);
  const Matrix<cl_R> e2 = e * e;
  const Matrix<cl_R> e4 = e2 * e2;
  const cl_R t8 = squared_norm(e4);
  const cl_R t16 = squared_norm(e4 * e4);
  return {squared_norm(e) / kFunctions, cln::sqrt(cln::sqrt(t16 / t8)), cln::sqrt(cln::sqrt(cln::sqrt(t16)))};
}

// digit * unit, as it is printed: to one digit.
struct OneDigit {
  int digit;
  cl_RA unit;
};
bool rounds_to(const cl_R& value, const OneDigit& printed) {
  const cl_RA half = fraction(1, 2);
  return cln::plusp(value - (printed.digit - half) * printed.unit) &&
         cln::minusp(value - (printed.digit + half) * printed.unit);
}

bool errors_round_to(int size, const OneDigit& mean, const OneDigit& worst) {
  const ErrorRange range = squared_errors(size);
  return rounds_to(range.mean, mean) && rounds_to(range.worst_lower, worst) && rounds_to(range.worst_upper, worst);
}
bool errors_of_small_cube_maps() {
  return errors_round_to(4, {3, fraction(1, 1000)}, {1, fraction(1, 100)}) &&
         errors_round_to(8, {3, fraction(1, 100000)}, {2, fraction(1, 10000)});
}

// Uniform light of radiance 1 from everywhere through a medium that absorbs nothing: (M_p)_0 times 2 sqrt(pi).
RadicalSum single_scattering(int directions, const RadicalSum& weight) {
  const SphereFunction y00 = sphere::spherical_harmonic(0, 0);
  const std::array<RadicalSum, 3> d{RadicalSum(), RadicalSum(), RadicalSum(1)};  // y_00 is the same everywhere
  RadicalSum m;
  for (int i = 0; i < directions; ++i) m += weight * y00.at(d);  // A(p -> p + D s_d) = 1
  return m * RadicalSum(Surd(2) * Surd::square_root(1, 1));
}
// A perfect scatterer in uniform light is invisible: radiance 1, however many directions are sampled.
bool volume_rule_as_printed() {
  return single_scattering(6, RadicalSum(1)) == RadicalSum(1) && single_scattering(12, RadicalSum(1)) == RadicalSum(1);
}
bool volume_rule_with_solid_angle_and_phase() {
  const auto weight = [](int directions) {
    const Surd solid_angle = Surd(fraction(4, directions)) * Surd::square_root(1, 2);
    const Surd isotropic = Surd(fraction(1, 4)) * Surd::square_root(1, -2);
    return RadicalSum(solid_angle * isotropic);
  };
  return single_scattering(6, weight(6)) == RadicalSum(1) && single_scattering(12, weight(12)) == RadicalSum(1);
}

constexpr int kVoxels = 20;

// A row of voxels, each letting through 3/4 of what enters; voxel 0 sends 1 along the row.
cl_RA transmittance(int voxels) { return cln::expt(fraction(3, 4), voxels); }

// What arrives at r by way of q is what arrives at r.
bool arriving_radiance_is_attenuated_along_the_ray() {
  for (int q = 1; q < kVoxels; ++q) {
    cl_RA radiance = 1;
    for (int voxel = 0; voxel < q; ++voxel) radiance = radiance - fraction(1, 4) * radiance;  // a quarter lost in each
    if (radiance != transmittance(q)) return false;
  }
  return true;
}
bool deposit_is_within_what_is_sent(const cl_RA& share) {
  cl_RA deposited = 0;
  for (int q = 0; q < kVoxels; ++q) deposited = deposited + share * transmittance(q);
  return deposited <= 1;
}
bool full_value_in_every_voxel() { return deposit_is_within_what_is_sent(1); }
bool scattered_share_in_every_voxel() { return deposit_is_within_what_is_sent(fraction(1, 4)); }

// Polynomials of degree <= n on the sphere: (n+1)^2 dimensions, and every monomial is a sum of y_i to degree n.
bool monomials_and_harmonics_span_the_same() {
  for (int n = 0; n <= 4; ++n) {
    if (sphere::rank_on_sphere(sphere::monomials(n)) != (n + 1) * (n + 1)) return false;
    for (const Polynomial& p : sphere::monomials(n)) {
      const SphereFunction f(Surd(1), p);
      if (!sphere::equal_on_sphere(sphere::expansion(sphere::projection(f, n)), f)) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Entry> sloan_sampling() {
  return {
      {"S-31",
       "6.2, weighted basis textures",
       Kind::kEquation,
       Print::kLost,
       "B_l^m(s) = y_l^m(s) ds(s), ds the differential solid angle; its formula is not given",
       Verdict::kDerived,
       {},
       "ds = (4/N^2) (1+u^2+v^2)^(-3/2) at (u,v) in [-1,1]^2; exactly: differences of atan(ab/sqrt(1+a^2+b^2))",
       texel_solid_angle,
       "From the derivative of s = (u,v,1)/|(u,v,1)|; the six faces have 4 pi."},
      {"S-32",
       "6.2, error for band-limited signals",
       Kind::kText,
       Print::kRead,
       "6th order, squared error: 6x4x4 images 0.3 % on average, 1 % at worst; 6x8x8 0.003 % and 0.02 %",
       Verdict::kCorrect,
       {{"ds at the centre of the texel, not normalised", errors_of_small_cube_maps}},
       "",
       nullptr,
       "0.265 % and 1.21 %, 0.0032 % and 0.016 %. With the exact areas 0.26/0.94 and 0.0058/0.018 %: not better for "
       "the larger images. Sums are exact in each term and computed to 40 digits."},
      {"S-33",
       "6.2, error for bilinear reconstruction",
       Kind::kText,
       Print::kRead,
       "6x8x8 0.7 % and 2 %; 6x16x16 0.2 % and 0.5 %; 6x32x32 0.05 % and 0.1 %",
       Verdict::kUndecided,
       {},
       "",
       nullptr,
       "What is compared is not said fully. The squared distance of the images, read between their texels, from a "
       "signal of 6 bands gives all six printed numbers for 8, 11 and 16 texels, as if not the edge but the number of "
       "texels had doubled (measured by quadrature, numeric's bilinear_error); with twice the edge it falls by 12."},
      {"S-34",
       "Footnote",
       Kind::kText,
       Print::kRead,
       "average: integrated squared difference, averaged over signals of unit power; worst: its maximum",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "For an error matrix E: |E|^2 / n^2 and its largest singular value squared."},
      {"S-35",
       "7, direct shadowing",
       Kind::kEquation,
       Print::kRead,
       "(M_p)_i^0 += A(p -> p + D s_d) y_i(s_d)",
       Verdict::kUnderReading,
       {{"the sum as it is", volume_rule_as_printed},
        {"times 4 pi/N_d, the phase function 1/(4 pi) and the albedo", volume_rule_with_solid_angle_and_phase}},
       "+= (4 pi/N_d) phase albedo A y_i",
       nullptr,
       "A perfect isotropic scatterer in uniform light must return radiance 1. A is the transmittance."},
      {"S-36",
       "7, interreflection",
       Kind::kEquation,
       Print::kRead,
       "(M_q)_i^b += A(p -> q) (M_p)_i^{b-1}",
       Verdict::kUnderReading,
       {{"the radiance that arrives at q", arriving_radiance_is_attenuated_along_the_ray},
        {"what q keeps of it: a row of voxels keeps no more than was sent", full_value_in_every_voxel}},
       "+= A(p -> q) M_p times the share scattered in q, sigma_s dt, and the phase function",
       scattered_share_in_every_voxel,
       "Every voxel of the ray receives the full attenuated value."},
      {"S-37",
       "Related work, spherical monomials",
       Kind::kText,
       Print::kRead,
       "they are related to the spherical harmonics by a linear transformation",
       Verdict::kCorrect,
       {{"on the sphere, degree <= 4", monomials_and_harmonics_span_the_same}},
       "",
       nullptr,
       "More monomials than functions: the map is onto, and one to one only for one parity of the degree."},
      {"S-38",
       "Table 1, timings",
       Kind::kTable,
       Print::kRead,
       "rates for 25-M, 25x25-M, 9x25-M",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "Measurements. Of the shapes, 9x25 takes 25 coefficients of light to 9."},
  };
}

}  // namespace sh::symbolic::errata
