// rotate: coefficients of a function turned by a 3x3 matrix.
#include "codegen/domains.hpp"
#include "codegen/families/families.hpp"
#include "codegen/literal.hpp"
#include "codegen/recipes/rotation.hpp"
#include "codegen/rotations.hpp"
#include "symbolic/quaternion_rotation.hpp"
#include "symbolic/rotation_recursion.hpp"

namespace sh::codegen {
namespace {

using symbolic::Matrix;
using symbolic::Surd;

constexpr int kMatrixSize = 9;
constexpr int kManyInputs = 5;  // kernels to this degree are small enough to be measured at more inputs
constexpr unsigned long kSeed = 1959;

int count_of(int degree) { return (degree + 1) * (degree + 1); }

// D_l c for every band, from the recursion in exact rationals.
std::vector<cln::cl_F> rotated(int degree, const std::vector<cln::cl_RA>& r, const std::vector<cln::cl_RA>& c) {
  const auto bands = symbolic::rotation_bands<cln::cl_RA>(degree, Matrix<cln::cl_RA>(3, 3, r), 1);
  std::vector<cln::cl_F> result;
  for (int l = 0; l <= degree; ++l) {
    const Matrix<Surd> d = symbolic::surd_entries(l, bands[symbolic::to_size(l)]);
    for (int m = 0; m <= 2 * l; ++m) {
      cln::cl_F sum = cln::cl_float(0, cln::float_format(kCheckDigits));
      for (int n = 0; n <= 2 * l; ++n) {
        sum = sum + (d(m, n) * Surd(c[symbolic::to_size(l * l + n)])).evaluate(kCheckDigits + 5);
      }
      result.push_back(sum);
    }
  }
  return result;
}

Reference reference(int degree, int count) {
  Reference reference;
  const auto coefficients = rational_vectors(count, count_of(degree), kSeed);
  const std::vector<RationalQuaternion> rotations = rational_rotations(count);
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    std::vector<cln::cl_RA> inputs = rotation_entries(rotations[i]);
    std::vector<cln::cl_F> outputs = rotated(degree, inputs, coefficients[i]);
    inputs.insert(inputs.end(), coefficients[i].begin(), coefficients[i].end());
    reference.push_back({std::move(inputs), std::move(outputs)});
  }
  return reference;
}

std::vector<std::vector<double>> test_inputs(int degree) {
  std::vector<std::vector<double>> inputs;
  const auto rotations = test_rotations(degree <= kManyInputs ? 6 : 2);
  const auto whole = unit_vectors(static_cast<int>(rotations.size()), count_of(degree), kSeed);
  const auto band = unit_vectors(static_cast<int>(rotations.size()), 2 * degree + 1, kSeed);
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    std::vector<double>& input = inputs.emplace_back();
    for (const cln::cl_RA& entry : rotation_entries(rotations[i])) input.push_back(nearest<double>(entry));
    if (i % 2 == 0) {
      input.insert(input.end(), whole[i].begin(), whole[i].end());
    } else {  // the highest band alone
      input.resize(input.size() + symbolic::to_size(degree * degree), 0.0);
      input.insert(input.end(), band[i].begin(), band[i].end());
    }
  }
  return inputs;
}

double length_of_coefficients(std::span<const double> inputs, std::size_t /*output*/) {
  return length(inputs.subspan(kMatrixSize));
}

std::vector<cln::cl_F> with_nearest_rotation(const std::vector<cln::cl_F>& inputs) {
  std::vector<cln::cl_F> result = nearest_rotation({inputs.begin(), inputs.begin() + kMatrixSize});
  result.insert(result.end(), inputs.begin() + kMatrixSize, inputs.end());
  return result;
}

}  // namespace

Family rotate_family() {
  return {"rotate",
          10,
          10,
          "beyond which straight-line code is too long to be useful",
          {{"zxz", recipes::rotate_zxz, 0, 10}},
          reference,
          {"turned unit vectors (random, axes, half turns, tilts from 2^-99 to pi)", "|c|",
           "the nearest rotation matrix", test_inputs, length_of_coefficients, with_nearest_rotation}};
}

}  // namespace sh::codegen
