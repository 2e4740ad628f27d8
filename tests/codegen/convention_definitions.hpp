// The conventions of engines and formats as explicit formulas, written down from their sources.
//
// A reference for emitted kernels. It shares nothing with symbolic/convention and codegen/convention: no factor, no index
// order, no axes. Legendre functions come from the standard library, which leaves out the Condon-Shortley phase.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace sh::codegen::test {

using Vector3 = std::array<double, 3>;

double dot(const Vector3& a, const Vector3& b);

/// A real convention by its definition.
struct Definition {
  std::string preset;
  std::function<double(int l, int m, const Vector3& d)> function;  ///< Y'_lm in the coordinates of the source
  std::function<int(int degree, int l, int m)> place;              ///< in an array of degrees 0 to `degree`
  std::function<int(int degree)> size;                             ///< of this array
  bool convolved = false;                                          ///< the coefficients hold A_l / pi
  int largest = 20;                                                ///< the largest degree
  bool own_axes = false;                                           ///< z is not the polar axis
};

/// Every real preset of `shgen emit --convention`.
const std::vector<Definition>& definitions();
const Definition& definition_of(const std::string& preset);

/// The orthonormal function without phase: sqrt((2 - delta) (2l+1) / (4 pi) (l-a)! / (l+a)!) P_l^a cos or sin, a = |m|.
double own_function(int l, int m, const Vector3& d);

/// Coordinates by their names: the axes "x,z,-y" of d are (d.x, d.z, -d.y).
Vector3 named_coordinates(std::string_view axes, const Vector3& d);

}  // namespace sh::codegen::test
