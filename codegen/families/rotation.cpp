// Rotation of coefficients: by a matrix, by a quaternion, about z; matrices built once and applied; the value of a
// rotated function.
#include "codegen/recipes/rotation/rotation.hpp"

#include <cln/real.h>

#include "codegen/families/exact.hpp"
#include "codegen/ir/literal.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/measure/rotations.hpp"
#include "symbolic/rotation/rotation.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"

namespace sh::codegen {
namespace {

using symbolic::Matrix;

constexpr unsigned long kSeed = 1959;
constexpr int kLargestDegree = 10;
// Kernels up to this degree are small enough for more test inputs.
constexpr int kManyInputs = 5;
constexpr const char* kTurnedVectors = "turned unit vectors (random, axes, half turns, tilts from 2^-99 to pi)";

// --- references

Rationals joined_lists(Rationals list, const Rationals& more) {
  list.insert(list.end(), more.begin(), more.end());
  return list;
}

// D_0 .. D_degree by the recursion in exact rationals.
std::vector<Matrix<Surd>> exact_bands(int degree, const Rationals& r) {
  const auto rational = symbolic::rotation_bands<cln::cl_RA>(degree, Matrix<cln::cl_RA>(3, 3, r), 1);
  std::vector<Matrix<Surd>> bands;
  for (int l = 0; l <= degree; ++l) bands.push_back(symbolic::surd_entries(l, rational[l]));
  return bands;
}

// Inputs and band matrices made from them. Each turns coefficients, which follow the inputs.
struct Turning {
  Rationals inputs;
  std::vector<Matrix<Surd>> bands;
};

Reference turned_reference(int degree, const std::vector<Turning>& turnings) {
  Reference reference;
  const auto coefficients = rational_vectors(static_cast<int>(turnings.size()), coefficient_count(degree), kSeed);
  for (const auto& [inputs, bands] : turnings) {
    const Rationals& c = coefficients[reference.size()];
    std::vector<cln::cl_F> turned;
    for (int l = 0; l <= degree; ++l) {
      for (int m = 0; m <= 2 * l; ++m) {
        cln::cl_F sum = precise(0);
        for (int n = 0; n <= 2 * l; ++n) sum = sum + precise(bands[l](m, n) * Surd(c[l * l + n]));
        turned.push_back(sum);
      }
    }
    reference.push_back({joined_lists(inputs, c), std::move(turned)});
  }
  return reference;
}

Reference rotate_reference(int degree, int points) {
  std::vector<Turning> turnings;
  for (const RationalQuaternion& q : rational_rotations(points)) {
    const Rationals r = rotation_entries(q);
    turnings.push_back({r, exact_bands(degree, r)});
  }
  return turned_reference(degree, turnings);
}

// The square of q scaled to length 1. It is rational and doubles the angle of the rotation.
RationalQuaternion unit_square(const RationalQuaternion& q) {
  RationalQuaternion square = symbolic::quaternion_product(q, q);
  const cln::cl_RA length = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  for (cln::cl_RA& component : square) component = component / length;
  return square;
}

Reference rotate_quaternion_reference(int degree, int points) {
  std::vector<RationalQuaternion> rotations = rational_rotations(points);
  rotations.back() = {0, 1, 2, 0};  // its square is a negative number, so beta = 0
  std::vector<Turning> turnings;
  for (const RationalQuaternion& q : rotations) {
    const RationalQuaternion unit = unit_square(q);
    turnings.push_back({{unit.begin(), unit.end()}, exact_bands(degree, rotation_entries(unit))});
  }
  return turned_reference(degree, turnings);
}

Reference rotate_z_reference(int degree, int points) {
  std::vector<Turning> turnings;
  for (const RationalQuaternion& q : rational_rotations(points)) {
    const RationalQuaternion unit = unit_square({q[0], 0, 0, q[1]});
    Turning& turning = turnings.emplace_back(Turning{{unit[0], unit[3]}, {}});
    for (int l = 0; l <= degree; ++l) {
      turning.bands.push_back(symbolic::rotation_about_z(l).mapped(
          [&](const symbolic::Polynomial& entry) { return Surd(entry.evaluate(turning.inputs)); }));
    }
  }
  return turned_reference(degree, turnings);
}

Reference rotate_build_reference(int degree, int points) {
  std::vector<Rationals> matrices;
  for (const RationalQuaternion& q : rational_rotations(points)) matrices.push_back(rotation_entries(q));
  return reference_at(matrices, [degree](const Rationals& r) {
    std::vector<cln::cl_F> entries;
    for (const Matrix<Surd>& d : exact_bands(degree, r)) {
      const int size = d.rows();
      const auto band = precise_values(size * size, [&](int i) { return d(i / size, i % size); });
      entries.insert(entries.end(), band.begin(), band.end());
    }
    return entries;
  });
}

Reference rotate_apply_reference(int degree, int points) {
  std::vector<Turning> turnings(points);
  for (int point = 0; point < points; ++point) {
    auto& [inputs, bands] = turnings[point];
    for (int l = 0; l <= degree; ++l) {
      const int size = 2 * l + 1;
      Rationals entries = rational_vectors(1, size * size, kSeed + point + l)[0];
      if (l == 0) entries = {1};
      inputs = joined_lists(std::move(inputs), entries);
      bands.push_back(
          Matrix<cln::cl_RA>(size, size, entries).mapped([](const cln::cl_RA& entry) { return Surd(entry); }));
    }
  }
  return turned_reference(degree, turnings);
}

Reference rotate_evaluate_reference(int degree, int points) {
  Reference reference = rotate_reference(degree, points);
  for (std::size_t k = 0; k < reference.size(); ++k) {
    ReferencePoint& point = reference[k];
    const Rationals r = rotation_entries(unit_square(rational_rotations(points)[k]));
    const Rationals d{r[1], r[4], r[7]};  // a column of a rotation has length 1 exactly
    cln::cl_F value = precise(0);
    for (int i = 0; i < coefficient_count(degree); ++i) value = value + point.outputs[i] * precise(basis_value(i, d));
    point = {joined_lists(point.inputs, d), {value}};
  }
  return reference;
}

// --- inputs

std::vector<RationalQuaternion> rotations_for(int degree) { return test_rotations(degree <= kManyInputs ? 6 : 2); }

// Each row, followed by coefficients: even rows get all bands, odd rows only the highest band.
Inputs with_coefficients(const Inputs& rows, int degree) {
  auto coefficients = unit_vectors(static_cast<int>(rows.size()), coefficient_count(degree), kSeed);
  const auto band = unit_vectors(static_cast<int>(rows.size()), 2 * degree + 1, kSeed);
  for (std::size_t i = 1; i < rows.size(); i += 2) {
    coefficients[i].assign(degree * degree, 0.0);
    coefficients[i].insert(coefficients[i].end(), band[i].begin(), band[i].end());
  }
  return joined(rows, coefficients);
}

template <class Numbers>
std::vector<double> rounded(const Numbers& values) {
  std::vector<double> result;
  for (const cln::cl_RA& value : values) result.push_back(nearest<double>(value));
  return result;
}

Inputs matrix_inputs(int degree) {
  Inputs inputs;
  for (const RationalQuaternion& q : rotations_for(degree)) inputs.push_back(rounded(rotation_entries(q)));
  return inputs;
}

Inputs rotate_inputs(int degree) { return with_coefficients(matrix_inputs(degree), degree); }

// Quaternions, scaled to length 1 in double.
Inputs rotate_quaternion_inputs(int degree) {
  Inputs inputs;
  for (const RationalQuaternion& q : rotations_for(degree)) {
    std::vector<double>& unit = inputs.emplace_back(rounded(q));
    const double norm = length(unit);
    for (double& component : unit) component /= norm;
  }
  return with_coefficients(inputs, degree);
}

// The angles of the rotations, about z.
Inputs rotate_z_inputs(int degree) {
  Inputs inputs;
  for (const RationalQuaternion& q : rotations_for(degree)) {
    const Rationals r = rotation_entries({q[0], 0, 0, q[1] + q[2] + q[3]});
    inputs.push_back(rounded(Rationals{r[0], r[3]}));
  }
  return with_coefficients(inputs, degree);
}

Inputs rotate_apply_inputs(int degree) {
  const int count = degree <= kManyInputs ? 300 : 100;
  Inputs inputs(count);
  for (int l = 0; l <= degree; ++l) {
    const auto rows = unit_vectors(count * (2 * l + 1), 2 * l + 1, kSeed + l);
    for (std::size_t row = 0; row < rows.size(); ++row) {
      std::vector<double>& input = inputs[row % inputs.size()];
      input.insert(input.end(), rows[row].begin(), rows[row].end());
    }
  }
  return with_coefficients(inputs, degree);
}

Inputs rotate_evaluate_inputs(int degree) {
  const Inputs inputs = rotate_inputs(degree);
  return joined(inputs, unit_vectors(static_cast<int>(inputs.size()), 3, kSeed + 1));
}

}  // namespace

std::vector<Family> rotation_families() {
  return {
      {.name = "rotate",
       .largest_emitted = kLargestDegree,
       .recipes = {{"zxz", recipes::rotate_zxz, 0, kLargestDegree},
                   {"dense", recipes::rotate_dense, 2, 8},
                   {"recursive", recipes::rotate_recursive, 2, 3}},
       .reference = rotate_reference,
       .domain = {.inputs = kTurnedVectors, .unit = "|c|", .test_inputs = rotate_inputs, .sizes = {"|c|"}},
       .batch = BatchDriver{.what = "Coefficients of rotated functions, by rotation matrices",
                            .single = {10, 10, 10, 10, 10, 8},
                            .grouped = 4}},
      {.name = "rotate_quaternion",
       .largest_emitted = kLargestDegree,
       .recipes = {{"zxz", recipes::rotate_quaternion_zxz, 2, kLargestDegree},
                   {"polynomial", recipes::rotate_quaternion_polynomial, 0, 8}},
       .reference = rotate_quaternion_reference,
       .domain = {.inputs = kTurnedVectors, .unit = "|c|", .test_inputs = rotate_quaternion_inputs, .sizes = {"|c|"}}},
      {.name = "rotate_z",
       .recipes = {{"steps", recipes::rotate_z_steps}, {"products", recipes::rotate_z_products, 2}},
       .reference = rotate_z_reference,
       .domain = {.inputs = "unit vectors turned about z (random angles, quarter turns, angles from 2^-99)",
                  .unit = "|c|",
                  .test_inputs = rotate_z_inputs,
                  .sizes = {"|c|"}}},
      {.name = "rotate_build",
       .largest_emitted = kLargestDegree,
       .recipes = {{"dense", recipes::rotate_build_dense, 0, kLargestDegree},
                   {"recursive", recipes::rotate_build_recursive, 2, 5}},
       .reference = rotate_build_reference,
       .domain = {.inputs = "rotations (random, axes, half turns, tilts from 2^-99 to pi)",
                  .unit = "1",
                  .test_inputs = matrix_inputs,
                  .sizes = {"1"}}},
      {.name = "rotate_apply",
       .largest_emitted = kLargestDegree,
       .recipes = {{"rows", recipes::rotate_apply_rows, 0, kLargestDegree}},
       .reference = rotate_apply_reference,
       .domain = {.inputs = "random unit vectors and matrices with rows of length 1",
                  .unit = "|c|",
                  .test_inputs = rotate_apply_inputs,
                  .sizes = {"|c|"}}},
      {.name = "rotate_evaluate",
       .largest_emitted = kLargestDegree,
       .recipes = {{"turned", recipes::rotate_evaluate_turned, 0, kLargestDegree}},
       .reference = rotate_evaluate_reference,
       .domain = {.inputs = "turned unit vectors in random directions",
                  .unit = "|c| (degree+1) / sqrt(4 pi)",
                  .test_inputs = rotate_evaluate_inputs,
                  .sizes = {"|c| Y(0..L)"}}}};
}

}  // namespace sh::codegen
