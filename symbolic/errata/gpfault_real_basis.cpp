// gpfault.net, Introduction to Spherical Harmonics (2026), the real functions and y_00, y_1m, y_22 derived: GP-25 to
// GP-31.
#include <algorithm>
#include <array>
#include <cstdlib>

#include "symbolic/errata/gpfault_legendre.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/errata/sphere_function.hpp"

namespace sh::symbolic::errata {
namespace {

using namespace gpfault_legendre;
using sphere::SphereFunction;

Surd real_factor(int l, int m) {  // K_l^m as printed, with |m|
  const int a = std::abs(m);
  return Surd::square_root(fraction(2 * l + 1, 4) * factorial(l - a) / factorial(l + a), -1);
}

// sin^m t cos mp and sin^m t sin mp in x, y.
std::array<Polynomial, 2> azimuthal(int m) {
  std::array<Polynomial, 2> power{Polynomial(1), Polynomial()};
  const Polynomial y = Polynomial::variable(1);
  for (int i = 0; i < m; ++i) power = {x() * power[0] - y * power[1], x() * power[1] + y * power[0]};
  return power;
}

// The three cases as printed, in x, y, z.
SphereFunction real_function(int l, int m) {
  const int a = std::abs(m);
  const std::array<Polynomial, 3> at_z{Polynomial::variable(2), Polynomial(), Polynomial()};
  const SphereFunction p = SphereFunction(Surd(1), legendre_part(l, a)).substituted(at_z);
  const Surd root_two = Surd::square_root(2);
  if (m == 0) return SphereFunction(real_factor(l, 0)) * p;
  return SphereFunction(root_two * real_factor(l, m), azimuthal(a)[m > 0 ? 0 : 1]) * p;
}

bool real_definition_is_the_basis() {
  return for_orders(-kDegree, [](int l, int m) {
    return m < -l || sphere::equal_on_sphere(real_function(l, m), sphere::spherical_harmonic(l, m));
  });
}
bool factor_normalises_both_signs() {
  return for_orders(0, [](int l, int m) {
    const Surd one = real_factor(l, m) * real_factor(l, m) * squared_norm(l, m);
    return one == Surd(1) && real_factor(l, -m) == real_factor(l, m);
  });
}

bool constant_function() {
  const Surd y00 = Surd::square_root(fraction(1, 4), -1);
  return real_factor(0, 0) == y00 && y00 * y00 * Surd(4) * Surd::square_root(1, 2) == Surd(1);
}

bool band_one() {
  const Surd k = Surd::square_root(fraction(3, 4) * fraction(1, 2), -1);
  const Surd result = Surd::square_root(fraction(3, 4), -1);
  return real_factor(1, -1) == k && Surd::square_root(2) * k == result &&
         SphereFunction(result, Polynomial::variable(1)) == sphere::spherical_harmonic(1, -1) &&
         SphereFunction(result, Polynomial::variable(2)) == sphere::spherical_harmonic(1, 0) &&
         SphereFunction(result, Polynomial::variable(0)) == sphere::spherical_harmonic(1, 1);
}

// sqrt 2 sqrt((4+1)/(divisor pi) (2-2)!/(2+2)!) = sqrt(5/(48 pi))
bool first_step_of_y22(int divisor) {
  const Surd left = Surd::square_root(2) * Surd::square_root(fraction(4 + 1, divisor) / factorial(4), -1);
  return left == Surd::square_root(fraction(5, 48), -1) && left == Surd::square_root(2) * real_factor(2, 2);
}
bool first_step_as_printed() { return first_step_of_y22(1); }
bool first_step_with_four_pi() { return first_step_of_y22(4); }

bool remaining_steps_of_y22() {
  const Polynomial cos_p = Polynomial::variable(0);
  const Polynomial sin_p = Polynomial::variable(1);
  const Polynomial cos_t = Polynomial::variable(2);
  const Polynomial sin_t = Polynomial::variable(3);
  const Polynomial one(1);
  const Surd factor = Surd(fraction(1, 4)) * Surd::square_root(15, -1);
  const bool factors = Surd::square_root(fraction(5, 48), -1) * Surd(3) == factor &&
                       Surd::square_root(fraction(5 * 9, 48), -1) == factor &&
                       Surd::square_root(fraction(5 * 3, 16), -1) == factor;
  // cos 2p sin^2 t by the addition theorem, and the steps that follow it
  const Polynomial start = sphere::reduce_squared_cosines((cos_p * cos_p - sin_p * sin_p) * sin_t * sin_t);
  const Polynomial twice = cl_RA(2) * (cos_p * cos_p);
  const std::array<Polynomial, 3> steps{(twice - one) * sin_t * sin_t, twice * sin_t * sin_t - sin_t * sin_t,
                                        twice * sin_t * sin_t - one + cos_t * cos_t};
  const bool angles = std::all_of(steps.begin(), steps.end(), [&start](const Polynomial& step) {
    return sphere::reduce_squared_cosines(step) == start;
  });
  const Polynomial y = Polynomial::variable(1);
  const Polynomial z = Polynomial::variable(2);
  const Polynomial cartesian = cl_RA(2) * (x() * x()) + z * z;
  const std::array<Polynomial, 3> direction{cos_p * sin_t, sin_p * sin_t, cos_t};
  const SphereFunction in_angles = SphereFunction(Surd(1), cartesian - one).substituted(direction);
  return factors && angles && sphere::reduce_squared_cosines(in_angles.parts().begin()->second) == start &&
         cartesian - x() * x() - y * y - z * z == x() * x() - y * y &&
         sphere::equal_on_sphere(SphereFunction(factor, cartesian - one), sphere::spherical_harmonic(2, 2));
}

}  // namespace

std::vector<Entry> gpfault_real_basis() {
  return {
      {"GP-25",
       "The Actual Definition",
       Kind::kEquation,
       Print::kRead,
       "sqrt2 K_l^m cos(mp) P_l^m, m > 0; K_l^0 P_l^0; sqrt2 K_l^m sin(-mp) P_l^-m, m < 0",
       Verdict::kCorrect,
       {{"with this page's P: y_lm of this project", real_definition_is_the_basis}},
       "",
       nullptr,
       "Quoted from a paper whose own P has the Condon-Shortley phase: with that P every function of odd order has the "
       "other sign, which the page does not mention."},
      {"GP-26",
       "K with |m|",
       Kind::kEquation,
       Print::kRead,
       "sqrt((2l+1)/(4 pi) (l-|m|)!/(l+|m|)!)",
       Verdict::kCorrect,
       {{"K^2 times the integral of |P e^{imp}|^2 is 1", factor_normalises_both_signs}},
       "",
       nullptr,
       ""},
      {"GP-27",
       "y_0^0",
       Kind::kEquation,
       Print::kRead,
       "K_0^0 P_0^0 = sqrt(1/(4 pi))",
       Verdict::kCorrect,
       {{"K as printed, and its norm", constant_function}},
       "",
       nullptr,
       ""},
      {"GP-28",
       "y_1^-1, y_1^0, y_1^1",
       Kind::kEquation,
       Print::kRead,
       "K_1^-1 = sqrt(3/(4 pi) 1/2); sqrt2 K_1^-1 sin p sin t = sqrt(3/(4 pi)) y; likewise z, x",
       Verdict::kCorrect,
       {{"each step", band_one}},
       "",
       nullptr,
       ""},
      {"GP-29",
       "y_2^2, first step",
       Kind::kEquation,
       Print::kRead,
       "sqrt2 sqrt((4+1)/pi (2-|2|)!/(2+|2|)!) = sqrt(5/(48 pi))",
       Verdict::kWrong,
       {{"as printed", first_step_as_printed}},
       "sqrt2 sqrt((4+1)/(4 pi) (2-|2|)!/(2+|2|)!) = sqrt(5/(48 pi))",
       first_step_with_four_pi,
       "The 4 of 4 pi is missing: the left side as printed is twice the right one."},
      {"GP-30",
       "y_2^2, remaining steps",
       Kind::kEquation,
       Print::kRead,
       "sqrt(5/(48 pi)) 3 sin^2 t cos 2p = 1/4 sqrt(15/pi) (2 cos^2 p sin^2 t - 1 + cos^2 t) = 1/4 sqrt(15/pi) "
       "(2x^2+z^2-1) = 1/4 sqrt(15/pi) (x^2-y^2)",
       Verdict::kCorrect,
       {{"each step", remaining_steps_of_y22}},
       "",
       nullptr,
       ""},
      {"GP-31",
       "Reference to Sloan 2008, appendix A2",
       Kind::kTable,
       Print::kRead,
       "its tables to degree 5 have no typos as far as the author can tell",
       Verdict::kUndecided,
       {},
       "",
       nullptr,
       "The tables are not printed here; they can be decided against the exact basis once they are transcribed."},
  };
}

}  // namespace sh::symbolic::errata
