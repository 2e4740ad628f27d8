// Roles: the meaning of a kernel's parameters and results. Masks, conventions, batch drivers and checks go by the role,
// never by a name.
//
// The shape follows from the role and the degree, so parameters are made by the functions below. The order of a role's
// numbers is part of the role.
#pragma once

#include <string>
#include <vector>

namespace sh::codegen {

enum class Role {
  kDirection,              ///< scalar: component `axis` of a unit vector; x, y, z follow each other
  kVector,                 ///< scalar: component `axis` of a vector of any length; x, y, z follow each other
  kRotationMatrix,         ///< (3, 3), row by row
  kQuaternion,             ///< (4): w, x, y, z
  kBandMatrices,           ///< D_0, ..., D_degree one after the other, (2l+1)^2 numbers each, row by row
  kCosine,                 ///< scalar: of an angle of rotation about z; its sine follows
  kSine,                   ///< scalar: of the same angle
  kCapSize,                ///< scalar: 1 - cos(half-angle) of a cap
  kParameter,              ///< scalar of the family's own, such as the width of a window
  kWeight,                 ///< scalar: of a sample
  kColor,                  ///< scalar: radiance of a light, or its channel `axis`
  kValue,                  ///< scalar or (channels): the value of a function
  kCoefficients,           ///< (bands^2) or (channels, bands^2): at index l(l+1)+m
  kEvaluatedCoefficients,  ///< the same, summed with the basis as they are stored: with all that is folded into them
  kZonalCoefficients,      ///< (bands): of Y_l0, one a degree
  kBasisValues,            ///< (bands^2): Y_lm at index l(l+1)+m
  kBasisGradient,  ///< (bands^2): the derivatives of Y_lm by coordinate `axis`; those by x, y, z follow each other
  kMoments,        ///< (bands^2): of z^n Re (x+iy)^m at index l(l+1)+m, l = m+n, and of z^n Im (x+iy)^m at l(l+1)-m
  kPolynomial,     ///< (bands^2): of x^i y^j and z x^i y^j, the coefficients of a function on the sphere
  kLinearForm,     ///< (4): e_0 + e_1 y + e_2 z + e_3 x, a function of degree 1
  kQuadraticForm,  ///< (4, 4), row by row: of (x, y, z, 1)
};

/// "rotation matrix"
std::string role_name(Role role);

/// A parameter or a result.
struct Parameter {
  std::string name;
  std::vector<int> shape;  ///< empty: a scalar
  Role role = Role::kParameter;
  int degree = -1;  ///< of the functions in the array; -1: it has none
  int axis = -1;    ///< 0, 1, 2 for x, y, z or red, green, blue; -1: it is no component

  [[nodiscard]] int size() const;
  /// The number of functions that an array of coefficients holds; 1 for every other role.
  [[nodiscard]] int channels() const;
};

/// A parameter of a role that needs neither degree nor axis: kQuaternion, kRotationMatrix, kLinearForm,
/// kQuadraticForm and scalars.
Parameter parameter(Role role, std::string name);
/// An array of a role that has a degree; channels: 1 or 3, for coefficients.
Parameter array(Role role, std::string name, int degree, int channels = 1);
/// `before`, the components x, y, z of a direction (or of a vector), `after`.
std::vector<Parameter> with_direction(std::vector<Parameter> before, const std::vector<Parameter>& after = {},
                                      Role role = Role::kDirection);

/// True for numbers at index l(l+1)+m of which each is odd or even in x, y, z as Y_lm is.
bool is_by_degree_and_order(Role role);
/// True for the coefficients of a function by the basis, zonal ones included.
bool holds_coefficients(Role role);
/// True for components of which x, y, z follow each other and turn as a vector does.
bool is_coordinate(Role role);

int total_size(const std::vector<Parameter>& arrays);
/// The place of the array of that name; -1: there is none.
int position_of(const std::vector<Parameter>& arrays, const std::string& name);

}  // namespace sh::codegen
