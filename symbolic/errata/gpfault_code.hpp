// The code fragments of gpfault.net, Introduction to Spherical Harmonics (2026), their arithmetic alone, over any
// number type T.
//
// T needs + - * and a constructor from Surd; run on polynomials (sphere_function.hpp) a fragment gives its formula.
#pragma once

#include <array>
#include <vector>

#include "symbolic/number/matrix.hpp"
#include "symbolic/number/surd.hpp"

namespace sh::symbolic::errata::gpfault_code {

/// C[0..9] of "A Look at the Spherical Harmonic Polynomials".
inline std::array<Surd, 10> constants() {
  const auto root = [](int square, const cln::cl_RA& factor) { return Surd(factor) * Surd::square_root(square, -1); };
  const cln::cl_RA half = cln::cl_RA(1) / 2;
  const cln::cl_RA quarter = cln::cl_RA(1) / 4;
  const cln::cl_RA eighth = cln::cl_RA(1) / 8;
  return {root(1, half),    root(3, half),   root(15, half),   root(5, quarter), root(15, quarter),
          root(70, eighth), root(105, half), root(42, eighth), root(7, quarter), root(105, quarter)};
}

/// The sixteen functions y00 .. y33 in the order of evalSHBasis.
template <class T>
std::vector<T> basis(const T& x, const T& y, const T& z) {
  std::array<T, 10> c;
  for (std::size_t i = 0; i < c.size(); ++i) c[i] = T(constants()[i]);
  const auto n = [](int number) { return T(Surd(number)); };
  return {c[0],
          c[1] * y,
          c[1] * z,
          c[1] * x,
          c[2] * y * x,
          c[2] * y * z,
          c[3] * (n(3) * z * z - n(1)),
          c[2] * x * z,
          c[4] * (x * x - y * y),
          c[5] * y * (n(3) * x * x - y * y),
          c[6] * z * (y * x),
          c[7] * y * (n(5) * z * z - n(1)),
          c[8] * z * (n(5) * z * z - n(3)),
          c[7] * x * (n(5) * z * z - n(1)),
          c[9] * z * (x * x - y * y),
          c[5] * x * (x * x - n(3) * y * y)};
}

/// evalSHBasis(d, l): the default case serves every l but 0, 1 and 2.
template <class T>
std::vector<T> evaluate_basis(const std::array<T, 3>& d, int l) {
  std::vector<T> values = basis(d[0], d[1], d[2]);
  switch (l) {
    case 0:
      values.resize(1);
      break;
    case 1:
      values.resize(4);
      break;
    case 2:
      values.resize(9);
      break;
    default:
      break;
  }
  return values;
}

/// mulScalarBySHCoeffs
template <class T>
std::vector<T> multiply(const T& scalar, const std::vector<T>& coefficients) {
  std::vector<T> result;
  result.reserve(coefficients.size());
  for (const T& c : coefficients) result.push_back(scalar * c);
  return result;
}

/// addSHCoeffs
template <class T>
std::vector<T> add(const std::vector<T>& first, const std::vector<T>& second) {
  std::vector<T> result;
  for (std::size_t i = 0; i < second.size(); ++i) result.push_back(first.empty() ? second[i] : second[i] + first[i]);
  return result;
}

/// evalSHRepresentation
template <class T>
T evaluate(const std::vector<T>& coefficients, const std::array<T, 3>& d, int l) {
  const std::vector<T> values = evaluate_basis(d, l);
  T sum = T();
  for (std::size_t i = 0; i < coefficients.size(); ++i) sum = sum + coefficients[i] * values[i];
  return sum;
}

/// calcTexelWeight(x, y); area(a, b) is its areaElement.
template <class Number, class Area>
auto texel_weight(const Number& x, const Number& y, const Number& texel_size, const Area& area) {
  const Number x0 = x - texel_size;
  const Number y0 = y - texel_size;
  const Number x1 = x + texel_size;
  const Number y1 = y + texel_size;
  return area(x0, y0) - area(x0, y1) - area(x1, y0) + area(x1, y1);
}

/// projectCubemapToSH for one channel of linear texels: faces, columns, rows. texel(face, col, row) in 0..255;
/// face_coordinates(col, row), direction(face, coordinates) and weight(coordinates) are the functions that it calls.
template <class T, class Texel, class FaceCoordinates, class Direction, class Weight>
std::vector<T> project_cubemap(int cube_dim, int max_degree, const Texel& texel,
                               const FaceCoordinates& face_coordinates, const Direction& direction,
                               const Weight& weight) {
  std::vector<T> sum;
  for (int face = 0; face < 6; ++face) {
    for (int col = 0; col < cube_dim; ++col) {
      for (int row = 0; row < cube_dim; ++row) {
        const auto coordinates = face_coordinates(col, row);
        const std::array<T, 3> d = direction(face, coordinates);
        const T colour = texel(face, col, row) * T(Surd(cln::cl_RA(1) / 255));
        sum = add(sum, multiply(weight(coordinates) * colour, evaluate_basis(d, max_degree)));
      }
    }
  }
  return sum;
}

/// shEvaluateDiffuseL1(p)
template <class T>
std::array<T, 4> diffuse_l1(const std::array<T, 3>& p) {
  const T ay0 = T(Surd(cln::cl_RA(1) / 4));
  const T ay1 = T(Surd(cln::cl_RA(1) / 2));
  return {ay0, ay1 * p[1], ay1 * p[2], ay1 * p[0]};
}

}  // namespace sh::symbolic::errata::gpfault_code
