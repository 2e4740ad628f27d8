// Roles: the meaning of a kernel's parameters and results. Masks, conventions, batch drivers and checks read the role,
// never the name.
//
// The role and the degree determine the shape, so the functions below make all parameters. A role also fixes the order
// of its numbers.
#pragma once

#include <string>
#include <vector>

namespace sh::codegen {

/// The meaning of a parameter or result.
enum class Role {
  kDirection,              ///< scalar: component `axis` of a unit vector; x, y, z follow each other
  kVector,                 ///< scalar: component `axis` of a vector of any length; x, y, z follow each other
  kRotationMatrix,         ///< (3, 3), row by row
  kQuaternion,             ///< (4): w, x, y, z
  kBandMatrices,           ///< D_0, ..., D_degree one after the other, (2l+1)^2 numbers each, row by row
  kCosine,                 ///< scalar: cosine of an angle of rotation about z; its sine follows
  kSine,                   ///< scalar: sine of the same angle
  kCapSize,                ///< scalar: 1 - cos(half-angle) of a cap
  kParameter,              ///< scalar: a parameter of one family, such as the width of a window
  kWeight,                 ///< scalar: weight of a sample
  kColor,                  ///< scalar: radiance of a light, or its channel `axis`
  kValue,                  ///< scalar or (channels): the value of a function
  kCoefficients,           ///< (bands^2) or (channels, bands^2): at index l(l+1)+m
  kEvaluatedCoefficients,  ///< the same, but the stored coefficients, with all folded factors, multiply the basis
  kIrradiance,             ///< the same, of irradiance: A_l times the coefficients of radiance
  kLight,                  ///< the same, of the light that all records share
  kZonalCoefficients,      ///< (bands): coefficients of Y_l0, one for each degree
  kBasisValues,            ///< (bands^2): Y_lm at index l(l+1)+m
  kBasisGradient,  ///< (bands^2): derivatives of Y_lm by coordinate `axis`; derivatives by x, y, z follow each other
  kMoments,        ///< (bands^2): sums of z^n Re (x+iy)^m at index l(l+1)+m, l = m+n; of z^n Im (x+iy)^m at l(l+1)-m
  kPolynomial,     ///< (bands^2): the coefficients of x^i y^j and z x^i y^j of a function on the sphere
  kSamples,        ///< (samples) or (channels, samples): a function of `degree` at the nodes of transfer_apply
  kLinearForm,     ///< (4): e_0 + e_1 y + e_2 z + e_3 x, a function of degree 1
  kQuadraticForm,  ///< (4, 4), row by row: a quadratic form in (x, y, z, 1)
};

/// The name in texts: "rotation matrix".
std::string role_name(Role role);

/// A parameter or a result.
struct Parameter {
  std::string name;
  std::vector<int> shape;  ///< empty: a scalar
  Role role = Role::kParameter;
  int degree = -1;  ///< the degree of the functions in the array; -1: there is none
  int axis = -1;    ///< 0, 1, 2 for x, y, z or red, green, blue; -1: the parameter is not a component

  [[nodiscard]] int size() const;
  /// The number of functions that an array of coefficients holds; 1 for every other role.
  [[nodiscard]] int channels() const;
};

/// A parameter of a role that needs neither degree nor axis: kQuaternion, kRotationMatrix, kLinearForm,
/// kQuadraticForm and scalars.
Parameter parameter(Role role, std::string name);
/// An array of a role that has a degree; channels: 1 or 3, for coefficients.
Parameter array(Role role, std::string name, int degree, int channels = 1);
/// The list of `before`, then the components x, y, z of a direction (or of a vector), then `after`.
std::vector<Parameter> with_direction(std::vector<Parameter> before, const std::vector<Parameter>& after = {},
                                      Role role = Role::kDirection);

/// True for numbers that another kernel makes and that only make sense together: band matrices, samples.
bool is_prepared(Role role);
/// True for numbers that belong to no vertex: records that are computed together share them.
bool is_shared(Role role);
/// True for numbers at index l(l+1)+m that have the parities of Y_lm in x, y and z.
bool is_by_degree_and_order(Role role);
/// True for coefficients of a function in the basis, including zonal coefficients.
bool holds_coefficients(Role role);
/// True for components x, y, z that follow each other and rotate like a vector.
bool is_coordinate(Role role);

/// The number of elements of all arrays together.
int total_size(const std::vector<Parameter>& arrays);
/// The position of the array with that name; -1: there is none.
int position_of(const std::vector<Parameter>& arrays, const std::string& name);

}  // namespace sh::codegen
