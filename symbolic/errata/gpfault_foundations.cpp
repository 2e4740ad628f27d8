// gpfault.net, Introduction to Spherical Harmonics (2026), from function spaces to the printed basis functions and
// their Monte Carlo test: GP-01 to GP-14.
#include <algorithm>
#include <array>

#include "symbolic/errata/gpfault_code.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/errata/sphere_function.hpp"
#include "symbolic/number/polynomial_calculus.hpp"
#include "symbolic/zonal/zonal.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_RA;
using sphere::SphereFunction;

using Family = std::vector<Polynomial>;  // vectors are linear forms, functions any polynomials
using RankOf = int (*)(const Family&);

bool is_combination(const Polynomial& p, Family family, RankOf rank_of) {
  const int before = rank_of(family);
  family.push_back(p);
  return rank_of(family) == before;
}

// "f_i = sum over all j": i is not left out.
bool independent_as_printed(const Family& family, RankOf rank_of) {
  return std::none_of(family.begin(), family.end(),
                      [&](const Polynomial& p) { return is_combination(p, family, rank_of); });
}

bool independent_with_i_left_out(const Family& family, RankOf rank_of) {
  for (std::size_t i = 0; i < family.size(); ++i) {
    Family others = family;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    if (is_combination(family[i], others, rank_of)) return false;
  }
  return true;
}

Polynomial linear_form(int a, int b, int c) {
  return cl_RA(a) * Polynomial::variable(0) + cl_RA(b) * Polynomial::variable(1) + cl_RA(c) * Polynomial::variable(2);
}

Family axes() { return {linear_form(1, 0, 0), linear_form(0, 1, 0), linear_form(0, 0, 1)}; }
Family coplanar() { return {linear_form(1, 2, 3), linear_form(2, -1, 1), linear_form(3, 1, 4)}; }
Family squares_and_one() {
  return {Polynomial(1), Polynomial::variable(0).power(2), Polynomial::variable(1).power(2),
          Polynomial::variable(2).power(2)};
}

bool printed_definition_knows_the_axes_independent() { return independent_as_printed(axes(), sphere::rank); }
bool left_out_definition_tells_vectors_apart() {
  return independent_with_i_left_out(axes(), sphere::rank) && !independent_with_i_left_out(coplanar(), sphere::rank);
}
bool printed_definition_knows_band_one_independent() { return independent_as_printed(axes(), sphere::rank_on_sphere); }
bool left_out_definition_tells_functions_apart() {  // 1 = x^2 + y^2 + z^2 on the sphere
  return independent_with_i_left_out(axes(), sphere::rank_on_sphere) &&
         !independent_with_i_left_out(squares_and_one(), sphere::rank_on_sphere);
}

// f = sum_i (integral f Y_i) Y_i for every polynomial f of that degree.
bool finite_sums_reach_all_polynomials(int degree) {
  const std::vector<Polynomial> all = sphere::monomials(degree);
  return std::all_of(all.begin(), all.end(), [degree](const Polynomial& p) {
    const SphereFunction f(Surd(1), p);
    return sphere::equal_on_sphere(sphere::expansion(sphere::projection(f, degree)), f);
  });
}

bool functions_up_to_degree_2_need_more_than_9() { return !finite_sums_reach_all_polynomials(2); }
// Finite for a finite degree, and 1, z, .., z^n are independent for every n tried.
bool dimension_is_finite_by_degree_and_grows_without_it() {
  Family powers;
  for (int n = 0; n <= 12; ++n) {
    powers.push_back(Polynomial::variable(2).power(n));
    if (sphere::rank_on_sphere(powers) != n + 1) return false;
  }
  return sphere::rank_on_sphere(sphere::monomials(2)) == 9;
}

bool finite_sums_reach_polynomials_to_degree_4() { return finite_sums_reach_all_polynomials(4); }

// The step f = 1 for z > 0, else 0, which is one of the two values wherever it is printed at z = 0.
bool partial_sums_of_a_step_reach_it_on_the_edge() {
  const ZonalFamily& hemisphere = zonal_family("hemisphere");
  const std::array<RadicalSum, 3> edge{RadicalSum(1), RadicalSum(), RadicalSum()};
  RadicalSum sum;
  for (int l = 0; l <= 12; ++l) {
    sum += RadicalSum(hemisphere.integral(l).at({})) * sphere::spherical_harmonic(l, 0).at(edge);
  }
  return sum == RadicalSum(1) || sum == RadicalSum();
}

// 2l+1 functions a band: that many are needed for the polynomials of each degree.
bool counts_are_dimensions() {
  int count = 0;
  for (int l = 0; l <= 5; ++l) {
    for (int m = -l; m <= l; ++m) ++count;
    if (count != (l + 1) * (l + 1) || sphere::rank_on_sphere(sphere::monomials(l)) != count) return false;
  }
  return true;
}

std::vector<SphereFunction> printed_functions() {
  return gpfault_code::basis(SphereFunction::variable(0), SphereFunction::variable(1), SphereFunction::variable(2));
}

bool each_constant_normalises_its_functions() {
  const std::vector<SphereFunction> printed = printed_functions();
  return std::all_of(printed.begin(), printed.end(),
                     [](const SphereFunction& y) { return sphere::sphere_integral(y * y) == RadicalSum(1); });
}

bool equal_to_the_basis(const std::vector<SphereFunction>& printed, int degree) {
  const std::vector<SphereFunction> basis = sphere::spherical_harmonics(degree);
  return std::equal(printed.begin(), printed.end(), basis.begin(), basis.end(), sphere::equal_on_sphere);
}

bool printed_functions_are_the_basis() { return equal_to_the_basis(printed_functions(), 3); }

bool evaluation_is_right_up_to(int degree) {
  const std::array<SphereFunction, 3> d{SphereFunction::variable(0), SphereFunction::variable(1),
                                        SphereFunction::variable(2)};
  for (int l = 0; l <= degree; ++l) {
    if (!equal_to_the_basis(gpfault_code::evaluate_basis(d, l), l)) return false;
  }
  return true;
}
bool evaluation_is_right_to_degree_3() { return evaluation_is_right_up_to(3); }
bool evaluation_is_right_to_degree_4() { return evaluation_is_right_up_to(4); }

// On coefficients the helpers do what + and * do on functions.
bool helpers_are_linear() {
  const std::vector<RadicalSum> a = sphere::some_coefficients(2, 4);
  const std::vector<RadicalSum> b = sphere::some_coefficients(2, 7);
  const cl_RA scalar = cl_RA(-3) / 5;
  const auto sum = gpfault_code::add(a, b);
  const auto multiple = gpfault_code::multiply(RadicalSum(scalar), a);
  return sphere::expansion(sum) == sphere::expansion(a) + sphere::expansion(b) &&
         sphere::expansion(multiple) == SphereFunction(scalar) * sphere::expansion(a) && gpfault_code::add({}, a) == a;
}

// The mass of accepted points in a direction d: the integral of r^2 from 0 to where the ray leaves cube and ball.
cl_RA accepted_mass(const std::array<cl_RA, 3>& d) {
  const cl_RA largest = cln::max(cln::max(cln::abs(d[0]), cln::abs(d[1])), cln::abs(d[2]));
  const cl_RA leaves_cube = 1 / largest;
  const cl_RA leaves_ball = 1;  // n > 1 is rejected
  return cln::expt(cln::min(leaves_cube, leaves_ball), 3) / 3;
}

bool accepted_directions_are_uniform() {
  const cl_RA fifth = cl_RA(1) / 5;
  const cl_RA third = cl_RA(1) / 3;
  const cl_RA mass = accepted_mass({1, 0, 0});
  return accepted_mass({3 * fifth, -4 * fifth, 0}) == mass && accepted_mass({2 * third, third, 2 * third}) == mass;
}

// The expectation of (4 pi / N) sum y_i y_j for uniform directions, with the code's own y.
bool monte_carlo_test_is_unbiased() {
  const std::vector<SphereFunction> printed = printed_functions();
  for (std::size_t i = 0; i < printed.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      if (!(sphere::sphere_integral(printed[i] * printed[j]) == RadicalSum(i == j ? 1 : 0))) return false;
    }
  }
  return accepted_directions_are_uniform();
}

std::vector<Entry> function_spaces() {
  return {
      {"GP-01",
       "Function Space, independent vectors",
       Kind::kText,
       Print::kRead,
       "independent: for no v_i are there a_1..a_n with v_i = a_0 v_0 + ... + a_n v_n",
       Verdict::kWrong,
       {{"the sum runs over all indices, i among them", printed_definition_knows_the_axes_independent}},
       "for no i is v_i = sum over j != i of a_j v_j",
       left_out_definition_tells_vectors_apart,
       "a_i = 1, the rest 0, always solves the printed equation, so that not even the axes would be independent. The "
       "coefficients are listed from a_1 and used from a_0."},
      {"GP-02",
       "Function Space, independent functions",
       Kind::kText,
       Print::kRead,
       "no a_0..a_n with f_i = a_0 f_0 + ... + a_n f_n",
       Verdict::kWrong,
       {{"the sum runs over all indices, i among them", printed_definition_knows_band_one_independent}},
       "for no i is f_i = sum over j != i of a_j f_j",
       left_out_definition_tells_functions_apart,
       "The slip of GP-01. Decided on x, y, z, which are independent, and on 1, x^2, y^2, z^2, which are not."},
      {"GP-03",
       "Inner product of vectors",
       Kind::kEquation,
       Print::kRead,
       "p.q = sum_{i=0}^n p_i q_i",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "Vectors of n+1 components, numbered from 0."},
      {"GP-04",
       "Inner product of functions",
       Kind::kEquation,
       Print::kRead,
       "<f,g> = INT f g dw",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "For real functions; the inner product of this project."},
      {"GP-05",
       "Norm",
       Kind::kEquation,
       Print::kRead,
       "||f|| = sqrt(<f,f>)",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "The norm that belongs to GP-04."},
      {"GP-06",
       "Orthonormal basis",
       Kind::kText,
       Print::kRead,
       "<f_i,f_j> = delta_ij, independent, and every element is a unique combination",
       Verdict::kDefinition,
       {},
       "",
       nullptr,
       "Independence follows from orthonormality. For infinitely many functions a combination is a series, and the "
       "sense in which it converges has to be said (GP-08)."},
      {"GP-07",
       "Function Space, size of a basis",
       Kind::kText,
       Print::kRead,
       "the basis of a function space is always infinite",
       Verdict::kWrong,
       {{"of every function space, such as the functions of degree <= 2", functions_up_to_degree_2_need_more_than_9}},
       "infinite for all continuous functions on the sphere; (L+1)^2 functions for those of degree <= L",
       dimension_is_finite_by_degree_and_grows_without_it,
       "The spaces that the page goes on to use have 4, 9 and 16 dimensions."},
  };
}

std::vector<Entry> printed_basis() {
  return {
      {"GP-08",
       "Spherical harmonics as a basis",
       Kind::kText,
       Print::kRead,
       "every (piecewise) continuous function on the sphere is an infinite weighted sum of spherical harmonics",
       Verdict::kUnderReading,
       {{"in L2: every polynomial is a finite sum, and polynomials are dense",
         finite_sums_reach_polynomials_to_degree_4},
        {"at every point: the sums for a hemisphere reach 0 or 1 on its edge",
         partial_sums_of_a_step_reach_it_on_the_edge}},
       "convergence in L2",
       nullptr,
       "On the edge every partial sum is 1/2. For functions without a jump the series may still diverge at single "
       "points: continuity alone does not suffice, as for Fourier series (a theorem, not computed here)."},
      {"GP-09",
       "Degree and order",
       Kind::kText,
       Print::kRead,
       "degree l = 0,1,2,...; 2l+1 functions of order m = -l..l; the number of coefficients grows quadratically",
       Verdict::kCorrect,
       {{"sum of 2l+1 = (L+1)^2 = dimension of the polynomials of degree <= L", counts_are_dimensions}},
       "",
       nullptr,
       "The names of degree and order are those of this project."},
      {"GP-10",
       "Code, constants C[0..9]",
       Kind::kCode,
       Print::kRead,
       "sqrt(1/pi)/2, sqrt(3/pi)/2, sqrt(15/pi)/2, sqrt(5/pi)/4, sqrt(15/pi)/4, sqrt(70/pi)/8, sqrt(105/pi)/2, "
       "sqrt(42/pi)/8, sqrt(7/pi)/4, sqrt(105/pi)/4",
       Verdict::kCorrect,
       {{"each normalises the functions that use it", each_constant_normalises_its_functions}},
       "",
       nullptr,
       "sqrt(70)/8 = sqrt(35/2)/4 and sqrt(42)/8 = sqrt(21/2)/4."},
      {"GP-11",
       "Code, functions y00 .. y33",
       Kind::kCode,
       Print::kRead,
       "C0; C1 (y,z,x); C2 xy, C2 yz, C3 (3z^2-1), C2 xz, C4 (x^2-y^2); C5 y(3x^2-y^2), C6 xyz, C7 y(5z^2-1), "
       "C8 z(5z^2-3), C7 x(5z^2-1), C9 z(x^2-y^2), C5 x(x^2-3y^2)",
       Verdict::kCorrect,
       {{"y_lm of this project on the unit sphere, all 16", printed_functions_are_the_basis}},
       "",
       nullptr,
       "y_11 in the code is order -1, y11 order +1. Off the unit sphere they are not the solid harmonics."},
      {"GP-12",
       "Code evalSHBasis(d, l)",
       Kind::kCode,
       Print::kRead,
       "all functions up to degree l at index l(l+1)+m; the default case is degree 3",
       Verdict::kUnderReading,
       {{"for l = 0..3, as its comment says", evaluation_is_right_to_degree_3},
        {"for any l", evaluation_is_right_to_degree_4}},
       "refuse l outside 0..3",
       nullptr,
       "Any other l, negative ones included, silently gives the 16 values of degree 3. One caller passes a third "
       "argument, which is ignored."},
      {"GP-13",
       "Code mulScalarBySHCoeffs, addSHCoeffs",
       Kind::kCode,
       Print::kRead,
       "s c; elementwise sum, an empty first operand counts as zeros",
       Verdict::kCorrect,
       {{"they are + and * of the functions", helpers_are_linear}},
       "",
       nullptr,
       ""},
      {"GP-14",
       "Code testBasisFunctions",
       Kind::kCode,
       Print::kRead,
       "points in the cube, those outside the ball rejected, the rest normalised; (4 pi / N) sum y_i y_j",
       Verdict::kCorrect,
       {{"directions are uniform and the expectation is delta_ij", monte_carlo_test_is_unbiased}},
       "",
       nullptr,
       "A point at the origin would divide by zero (probability 0). With 1e5 samples entries scatter by some 1e-3."},
  };
}

}  // namespace

std::vector<Entry> gpfault_foundations() {
  std::vector<Entry> entries = function_spaces();
  for (Entry& entry : printed_basis()) entries.push_back(std::move(entry));
  return entries;
}

}  // namespace sh::symbolic::errata
