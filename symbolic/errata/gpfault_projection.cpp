// gpfault.net, Introduction to Spherical Harmonics (2026), coefficients and cube maps: GP-32 to GP-39.
#include <algorithm>
#include <array>

#include "symbolic/errata/gpfault_code.hpp"
#include "symbolic/errata/parts.hpp"
#include "symbolic/errata/sphere_function.hpp"
#include "symbolic/errata/texel_solid_angle.hpp"
#include "symbolic/rotation/rotation_input.hpp"
#include "symbolic/zonal/zonal.hpp"

namespace sh::symbolic::errata {
namespace {

using cln::cl_RA;
using sphere::SphereFunction;
using texel::CornerSum;

constexpr int kCubeDim = 128;  // the page's CUBE_DIM

cl_RA fraction(int numerator, int denominator) { return cl_RA(numerator) / denominator; }
Surd pi() { return Surd::square_root(1, 2); }

// What the bands up to `degree` of a hemisphere, f = 1 for z > 0, leave of the integral of f^2.
cl_RA energy_left(int degree) {
  const ZonalFamily& hemisphere = zonal_family("hemisphere");
  Surd left = Surd(2) * pi();
  for (int l = 0; l <= degree; ++l) {
    const Surd z = hemisphere.integral(l).at({});
    left = left + -(z * z);
  }
  return (left / pi()).rational();
}

bool energy_of_a_hemisphere_is_exhausted() {
  const std::array<int, 4> degrees{3, 7, 15, 31};
  cl_RA before = energy_left(1);
  for (const int degree : degrees) {  // falls like 1/degree
    const cl_RA left = energy_left(degree);
    if (!cln::plusp(left) || 5 * left > 3 * before) return false;
    before = left;
  }
  return true;
}

// The value on the edge, z = 0, is 0 or 1 by whatever definition of the hemisphere.
bool sums_for_a_hemisphere_meet_its_edge() {
  const ZonalFamily& hemisphere = zonal_family("hemisphere");
  const std::array<RadicalSum, 3> edge{RadicalSum(fraction(3, 5)), RadicalSum(fraction(4, 5)), RadicalSum()};
  RadicalSum sum;
  for (int l = 0; l <= 9; ++l) {
    sum += RadicalSum(hemisphere.integral(l).at({})) * sphere::zonal_harmonic(l).at(edge);
  }
  return sum == RadicalSum(1) || sum == RadicalSum();
}

using Vector = std::array<cl_RA, 3>;

cl_RA dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// v = (v.i) i + (v.j) j + (v.k) k
bool inner_products_are_coordinates(const std::array<Vector, 3>& basis) {
  const Vector v{fraction(7, 3), -2, fraction(1, 5)};
  Vector sum{0, 0, 0};
  for (const Vector& axis : basis) {
    for (std::size_t i = 0; i < 3; ++i) sum[i] = sum[i] + dot(v, axis) * axis[i];
  }
  return sum == v;
}
bool coordinates_in_a_skew_basis() { return inner_products_are_coordinates({{{1, 0, 0}, {1, 1, 0}, {0, 2, 1}}}); }
bool coordinates_in_an_orthonormal_basis() {
  const Matrix<cl_RA> r = sphere::some_rotation();
  std::array<Vector, 3> basis;
  for (int row = 0; row < 3; ++row) basis[to_size(row)] = {r(row, 0), r(row, 1), r(row, 2)};
  return inner_products_are_coordinates(basis);
}

// The inner products of a sum of c_i y_i give back c.
bool inner_products_are_coefficients() {
  const std::vector<RadicalSum> coefficients = sphere::some_coefficients(3, 3);
  return sphere::projection(sphere::expansion(coefficients), 3) == coefficients;
}

// The sum over texels of T(p) y(p') S with the exact areas, which are all equal for one or four texels a face.
RadicalSum riemann_sum(int size, const SphereFunction& f) {
  const auto directions = texel::cube_directions(size);
  const Surd area = Surd(fraction(4, static_cast<int>(directions.size()))) * pi();
  RadicalSum sum;
  for (const auto& d : directions) sum += RadicalSum(area) * f.at(d);
  return sum;
}

bool texels_of_a_face_are_equal(int size) {
  const auto corner = [](const cl_RA& a, const cl_RA& b) { return CornerSum::corner(a, b); };
  const CornerSum share = fraction(4, size * size) * CornerSum::corner(1, 1);
  const std::vector<cl_RA> centres = texel::texel_centres(size);
  return std::all_of(centres.begin(), centres.end(), [&](const cl_RA& centre) {
    return gpfault_code::texel_weight(centre, centres.front(), fraction(1, size), corner) == share;
  });
}

// Constants are exact, and the error of z^4 falls by four when the texels are halved.
bool riemann_sums_converge() {
  const SphereFunction y00 = sphere::spherical_harmonic(0, 0);
  const SphereFunction z4(Surd(1), Polynomial::variable(2).power(4));
  const RadicalSum exact = sphere::sphere_integral(z4);
  const RadicalSum coarse = riemann_sum(1, z4) - exact;
  const RadicalSum fine = riemann_sum(2, z4) - exact;
  return texels_of_a_face_are_equal(1) && texels_of_a_face_are_equal(2) && texel::corner_of_face_is_sixth_of_pi() &&
         riemann_sum(2, y00) == RadicalSum(Surd(2) * Surd::square_root(1, 1)) && !coarse.is_zero() &&
         coarse == RadicalSum(-4) * fine;
}

// 4/N^2 (1+u^2+v^2)^(-3/2)
Surd estimated_area(int size, const cl_RA& u, const cl_RA& v) {
  const cl_RA square = 1 + u * u + v * v;
  return Surd(fraction(4, size * size) / square) * Surd::square_root(1 / square);
}

CornerSum exact_area(int size, const cl_RA& u, const cl_RA& v) {
  return gpfault_code::texel_weight(u, v, fraction(1, size),
                                    [](const cl_RA& a, const cl_RA& b) { return CornerSum::corner(a, b); });
}

// 2x2: the estimate is an algebraic number, the area pi/6.
bool estimate_misses_the_area() {
  return texels_of_a_face_are_equal(2) && texel::corner_of_face_is_sixth_of_pi() &&
         !(estimated_area(2, fraction(1, 2), fraction(1, 2)) == Surd(fraction(1, 6)) * pi());
}

bool deviates_by_more_than(const cl_RA& limit, const cln::cl_F& ratio) {
  return cln::plusp(cln::abs(ratio - 1) - limit);
}

// 4x4: corner against centre, so that a common factor drops out, is wrong by 1 to 6 % (40 digits are computed).
bool normalised_estimate_misses_the_area() {
  const cl_RA inner = fraction(1, 4);
  const cl_RA outer = fraction(3, 4);
  const cln::cl_F exact = exact_area(4, outer, outer).evaluate(40) / exact_area(4, inner, inner).evaluate(40);
  const cln::cl_F estimate = (estimated_area(4, outer, outer) / estimated_area(4, inner, inner)).evaluate(40);
  return deviates_by_more_than(fraction(1, 100), estimate / exact) &&
         !deviates_by_more_than(fraction(6, 100), estimate / exact);
}

// Windows [centre - h, centre + h] that cover [-1, 1] once.
bool windows_tile_the_face(const std::vector<cl_RA>& centres, const cl_RA& half) {
  cl_RA edge = -1;
  for (const cl_RA& centre : centres) {
    if (centre - half != edge) return false;
    edge = centre + half;
  }
  return edge == 1;
}

std::vector<cl_RA> uv_centres(int count) {
  std::vector<cl_RA> centres(to_size(count));
  for (int k = 0; k < count; ++k) centres[to_size(k)] = fraction(2 * k + 1, 2 * count);
  return centres;
}

bool weight_is_the_solid_angle(const std::vector<cl_RA>& centres) {
  const cl_RA texel_size = fraction(1, static_cast<int>(centres.size()));
  const CornerSum face = cl_RA(4) * CornerSum::corner(1, 1);
  return texel::corner_integrates_area_element() && exact_area(1, 0, 0) == face &&
         windows_tile_the_face(centres, texel_size);
}
bool weight_in_cube_coordinates() { return weight_is_the_solid_angle(texel::texel_centres(kCubeDim)); }
bool weight_in_uv_coordinates() { return weight_is_the_solid_angle(uv_centres(kCubeDim)); }

CornerSum sum_of_weights(const std::vector<cl_RA>& centres) {
  CornerSum sum;
  for (const cl_RA& x : centres) {
    for (const cl_RA& y : centres) sum = sum + exact_area(static_cast<int>(centres.size()), x, y);
  }
  return sum;
}

bool weights_sum_to_the_sphere() {
  const CornerSum face = cl_RA(4) * CornerSum::corner(1, 1);
  return texel::corner_of_face_is_sixth_of_pi() && sum_of_weights(texel::texel_centres(5)) == face &&
         sum_of_weights(texel::texel_centres(8)) == face;
}

// With coordinates in [0, 1] every window is wrong; the sum over all of them differs from 4 pi by this much.
bool sum_reveals_wrong_weights() {
  const cln::cl_F face = sum_of_weights(uv_centres(kCubeDim)).evaluate(30);
  const cln::cl_F share = (Surd(fraction(2, 3)) * pi()).evaluate(30);
  return weights_sum_to_the_sphere() && deviates_by_more_than(fraction(1, 1000), face / share);
}

using FaceCoordinates = std::array<cl_RA, 2>;

std::array<SphereFunction, 3> direction(int face, const FaceCoordinates& uv) {
  const Surd scale = Surd::square_root(1 / (1 + uv[0] * uv[0] + uv[1] * uv[1]));
  const std::array<SphereFunction, 3> axes{SphereFunction(face < 3 ? scale : -scale),
                                           SphereFunction(Surd(uv[0]) * scale), SphereFunction(Surd(uv[1]) * scale)};
  const auto at = [&axes, face](int i) { return axes[to_size((i - face % 3 + 3) % 3)]; };
  return {at(0), at(1), at(2)};
}

// 2x2 texels a face; the weights are unknown positive numbers (variables 3, 4, ..), the same for mirrored coordinates.
SphereFunction unknown_weight(const FaceCoordinates& uv) {
  const cl_RA sum = cln::abs(uv[0]) + cln::abs(uv[1]);
  return SphereFunction::variable(sum < 1 ? 3 : sum == 1 ? 4 : 5);
}

// Light from the face +z alone is symmetric about z: no x, no y in band 1, and z times four equal texels.
bool cube_map_is_projected(const std::vector<cl_RA>& centres) {
  const auto texel = [](int face, int, int) { return SphereFunction(face == 2 ? 255 : 0); };
  const auto coordinates = [&centres](int col, int row) {
    return FaceCoordinates{centres[to_size(col)], centres[to_size(row)]};
  };
  const std::vector<SphereFunction> c =
      gpfault_code::project_cubemap<SphereFunction>(2, 1, texel, coordinates, direction, unknown_weight);
  const Surd value = Surd(4) * Surd::square_root(fraction(3, 4), -1) * Surd::square_root(fraction(2, 3));
  return c[1].is_zero() && c[3].is_zero() && c[2] == SphereFunction(value, Polynomial::variable(4));
}
bool cube_map_in_cube_coordinates() { return cube_map_is_projected(texel::texel_centres(2)); }
bool cube_map_in_uv_coordinates() { return cube_map_is_projected(uv_centres(2)); }

}  // namespace

std::vector<Entry> gpfault_projection() {
  return {
      {"GP-32",
       "f as a sum",
       Kind::kEquation,
       Print::kRead,
       "f = c_0^0 y_0^0 + c_1^-1 y_1^-1 + c_1^0 y_1^0 + ...",
       Verdict::kUnderReading,
       {{"in L2: the energy that is left falls towards 0 even for a step", energy_of_a_hemisphere_is_exhausted},
        {"at every point of a piecewise continuous function", sums_for_a_hemisphere_meet_its_edge}},
       "equality in L2",
       nullptr,
       "Printed twice, for piecewise continuous and for continuous functions. The energy left of a hemisphere falls "
       "like "
       "1/degree; on its edge every partial sum is 1/2."},
      {"GP-33",
       "Coordinates by inner products",
       Kind::kText,
       Print::kRead,
       "coordinates of v in a basis i, j, k are v.i, v.j, v.k, the lengths of its projections",
       Verdict::kUnderReading,
       {{"any basis", coordinates_in_a_skew_basis}, {"an orthonormal basis", coordinates_in_an_orthonormal_basis}},
       "c = G^-1 (v.i, v.j, v.k), G the matrix of inner products of the basis",
       nullptr,
       "Said of some basis. A projection has length v.i only for |i| = 1."},
      {"GP-34",
       "Coefficients",
       Kind::kEquation,
       Print::kRead,
       "c_l^m = <f, y_l^m> = INT f y_l^m dw",
       Verdict::kCorrect,
       {{"they are the factors of f = sum c y, degree <= 3", inner_products_are_coefficients}},
       "",
       nullptr,
       "In one place the letters i, j stand for m, l."},
      {"GP-35",
       "Riemann sum over texels",
       Kind::kText,
       Print::kRead,
       "c = sum over texels of T(p) y(p') S, S the area of the texel projected to the sphere",
       Verdict::kCorrect,
       {{"constants exact, error of z^4 falls by 4 from one texel a face to four", riemann_sums_converge}},
       "",
       nullptr,
       "Areas are called proportional to solid angles; on the unit sphere they are equal."},
      {"GP-36",
       "Text on the simpler estimate of the area",
       Kind::kText,
       Print::kRead,
       "(4/N^2) (1+u^2+v^2)^(-3/2) at the centre of the texel is less precise",
       Verdict::kCorrect,
       {{"the number itself, 2x2 texels", estimate_misses_the_area},
        {"up to a common factor, 4x4 texels", normalised_estimate_misses_the_area}},
       "",
       nullptr,
       "The formula is the one that the page refers to. For projecting band-limited signals it is nevertheless not the "
       "worse choice, see S-32."},
      {"GP-37",
       "Code calcTexelWeight(x, y)",
       Kind::kCode,
       Print::kRead,
       "A(a,b) = atan2(ab, sqrt(a^2+b^2+1)); A(x0,y0)-A(x0,y1)-A(x1,y0)+A(x1,y1), x0, x1 = x -+ 1/CUBE_DIM",
       Verdict::kUnderReading,
       {{"face coordinates of texel centres in [-1,1]", weight_in_cube_coordinates},
        {"in [0,1], as the comments on UV space suggest", weight_in_uv_coordinates}},
       "half a texel is 1/CUBE_DIM in [-1,1]",
       nullptr,
       "Decided: d^2A/da db = (1+a^2+b^2)^(-3/2), and the windows cover the face once. cubemapFaceCoords is not "
       "printed; HALF_TEXEL_SIZE is not used here."},
      {"GP-38",
       "Text on the sum of the weights",
       Kind::kText,
       Print::kRead,
       "all weights sum to about 4 pi, which verifies the function",
       Verdict::kUnderReading,
       {{"the sum is 4 pi, in [-1,1] exactly", weights_sum_to_the_sphere},
        {"the sum shows that single weights are right", sum_reveals_wrong_weights}},
       "check single weights: a corner texel, or a quarter of a face, pi/6",
       nullptr,
       "With coordinates in [0,1] every weight is wrong, and at CUBE_DIM = 128 the sum is still within 0.1 % of 4 pi."},
      {"GP-39",
       "Code projectCubemapToSH",
       Kind::kCode,
       Print::kRead,
       "coefficients += weight * texel/255 * y(d) over faces, columns, rows",
       Verdict::kUnderReading,
       {{"face coordinates in [-1,1]", cube_map_in_cube_coordinates},
        {"face coordinates in [0,1]", cube_map_in_uv_coordinates}},
       "c = sum S T y",
       nullptr,
       "Run on 2x2 texels a face with unknown weights and our own map of the faces; the page's maps are not printed."},
  };
}

}  // namespace sh::symbolic::errata
