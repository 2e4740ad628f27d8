#include "codegen/families/rotation_inputs.hpp"

#include <cln/real.h>

#include "codegen/ir/literal.hpp"
#include "codegen/measure/domains.hpp"
#include "codegen/measure/rotations.hpp"
#include "numeric/oracle/index.hpp"
#include "symbolic/basis/basis.hpp"
#include "symbolic/rotation/rotation.hpp"
#include "symbolic/rotation/rotation_recursion.hpp"

namespace sh::codegen {
namespace {

using symbolic::Matrix;
using symbolic::Surd;
using symbolic::to_size;
using Rationals = std::vector<cln::cl_RA>;
using Surds = Matrix<Surd>;

constexpr unsigned long kSeed = 1959;
// Kernels up to this degree are small enough for more test inputs.
constexpr int kManyInputs = 5;

using numeric::coefficient_count;

// D_0 .. D_degree by the recursion in exact rationals.
std::vector<Surds> exact_bands(int degree, const Rationals& r) {
  const auto rational = symbolic::rotation_bands<cln::cl_RA>(degree, Matrix<cln::cl_RA>(3, 3, r), 1);
  std::vector<Surds> bands;
  for (int l = 0; l <= degree; ++l) bands.push_back(symbolic::surd_entries(l, rational[l]));
  return bands;
}

// Each matrix times its part of c.
std::vector<cln::cl_F> times(const std::vector<Surds>& bands, const Rationals& c) {
  std::vector<cln::cl_F> result;
  std::size_t first = 0;
  for (const Surds& d : bands) {
    for (int m = 0; m < d.rows(); ++m) {
      cln::cl_F sum = cln::cl_float(0, cln::float_format(kCheckDigits));
      for (int n = 0; n < d.columns(); ++n) sum = sum + (d(m, n) * Surd(c[first + to_size(n)])).evaluate(kCheckDigits);
      result.push_back(sum);
    }
    first += to_size(d.columns());
  }
  return result;
}

void append(Rationals& list, const Rationals& more) { list.insert(list.end(), more.begin(), more.end()); }

// The reference point at which the matrices made from `inputs` turn c.
ReferencePoint turned_point(Rationals inputs, const std::vector<Surds>& bands, const Rationals& c) {
  std::vector<cln::cl_F> outputs = times(bands, c);
  append(inputs, c);
  return {std::move(inputs), std::move(outputs)};
}

// The square of q scaled to length 1. It is rational and doubles the angle of the rotation.
Rationals unit_square(const RationalQuaternion& q) {
  const RationalQuaternion square = symbolic::quaternion_product(q, q);
  const cln::cl_RA length = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  Rationals unit;
  for (const cln::cl_RA& component : square) unit.push_back(component / length);
  return unit;
}

// Each row, followed by coefficients: even rows get all bands, odd rows only the highest band.
std::vector<std::vector<double>> with_coefficients(const std::vector<std::vector<double>>& rows, int degree) {
  auto coefficients = unit_vectors(static_cast<int>(rows.size()), coefficient_count(degree), kSeed);
  const auto band = unit_vectors(static_cast<int>(rows.size()), 2 * degree + 1, kSeed);
  for (std::size_t i = 1; i < rows.size(); i += 2) {
    coefficients[i].assign(to_size(degree * degree), 0.0);
    coefficients[i].insert(coefficients[i].end(), band[i].begin(), band[i].end());
  }
  return joined(rows, coefficients);
}

std::vector<RationalQuaternion> rotations_for(int degree) { return test_rotations(degree <= kManyInputs ? 6 : 2); }

void append_rounded(std::vector<double>& input, const Rationals& values) {
  for (const cln::cl_RA& value : values) input.push_back(nearest<double>(value));
}

// Scaled to length 1 in double.
void append_unit(std::vector<double>& input, const RationalQuaternion& q) {
  std::vector<double> unit;
  for (const cln::cl_RA& component : q) unit.push_back(nearest<double>(component));
  const double norm = length(unit);
  for (const double component : unit) input.push_back(component / norm);
}

}  // namespace

Reference rotate_reference(int degree, int count) {
  Reference reference;
  const auto coefficients = rational_vectors(count, coefficient_count(degree), kSeed);
  for (const RationalQuaternion& q : rational_rotations(count)) {
    const Rationals r = rotation_entries(q);
    reference.push_back(turned_point(r, exact_bands(degree, r), coefficients[reference.size()]));
  }
  return reference;
}

Reference rotate_quaternion_reference(int degree, int count) {
  Reference reference;
  const auto coefficients = rational_vectors(count, coefficient_count(degree), kSeed);
  std::vector<RationalQuaternion> rotations = rational_rotations(count);
  rotations.back() = {0, 1, 2, 0};  // its square is a negative number, so beta = 0
  for (const RationalQuaternion& q : rotations) {
    const Rationals unit = unit_square(q);
    const Rationals r = rotation_entries({unit[0], unit[1], unit[2], unit[3]});
    reference.push_back(turned_point(unit, exact_bands(degree, r), coefficients[reference.size()]));
  }
  return reference;
}

Reference rotate_z_reference(int degree, int count) {
  Reference reference;
  const auto coefficients = rational_vectors(count, coefficient_count(degree), kSeed);
  for (const RationalQuaternion& q : rational_rotations(count)) {
    const Rationals unit = unit_square({q[0], 0, 0, q[1]});
    const Rationals inputs{unit[0], unit[3]};
    std::vector<Surds> bands;
    for (int l = 0; l <= degree; ++l) {
      const auto about_z = symbolic::rotation_about_z(l);
      Surds& band = bands.emplace_back(2 * l + 1, 2 * l + 1);
      for (int m = 0; m <= 2 * l; ++m) {
        for (int n = 0; n <= 2 * l; ++n) band(m, n) = Surd(about_z(m, n).evaluate(inputs));
      }
    }
    reference.push_back(turned_point(inputs, bands, coefficients[reference.size()]));
  }
  return reference;
}

Reference rotate_build_reference(int degree, int count) {
  Reference reference;
  for (const RationalQuaternion& q : rational_rotations(count)) {
    const Rationals inputs = rotation_entries(q);
    std::vector<cln::cl_F> outputs;
    for (const Surds& d : exact_bands(degree, inputs)) {
      for (int i = 0; i < d.rows() * d.rows(); ++i) {
        outputs.push_back(d(i / d.rows(), i % d.rows()).evaluate(kCheckDigits));
      }
    }
    reference.push_back({inputs, std::move(outputs)});
  }
  return reference;
}

Reference rotate_apply_reference(int degree, int count) {
  Reference reference;
  const auto coefficients = rational_vectors(count, coefficient_count(degree), kSeed);
  for (const Rationals& c : coefficients) {
    Rationals inputs;
    std::vector<Surds> bands;
    for (int l = 0; l <= degree; ++l) {
      const int size = 2 * l + 1;
      Rationals entries = rational_vectors(1, size * size, kSeed + reference.size() + to_size(l))[0];
      if (l == 0) entries = {1};
      Surds& band = bands.emplace_back(size, size);
      for (int i = 0; i < size * size; ++i) band(i / size, i % size) = Surd(entries[i]);
      append(inputs, entries);
    }
    reference.push_back(turned_point(std::move(inputs), bands, c));
  }
  return reference;
}

Reference rotate_evaluate_reference(int degree, int count) {
  Reference reference;
  for (const ReferencePoint& rotated : rotate_reference(degree, count)) {
    const Rationals unit = unit_square(rational_rotations(count)[reference.size()]);
    const Rationals r = rotation_entries({unit[0], unit[1], unit[2], unit[3]});
    const Rationals d{r[1], r[4], r[7]};  // a column of a rotation has length 1 exactly
    cln::cl_F value = cln::cl_float(0, cln::float_format(kCheckDigits));
    for (int l = 0; l <= degree; ++l) {
      for (int m = -l; m <= l; ++m) {
        const symbolic::BasisFunction f = symbolic::basis_function(l, m);
        const Surd y = Surd(f.homogeneous.evaluate(d)) * f.factor;
        value = value + rotated.outputs[l * (l + 1) + m] * y.evaluate(kCheckDigits);
      }
    }
    Rationals inputs = rotated.inputs;
    append(inputs, d);
    reference.push_back({std::move(inputs), {value}});
  }
  return reference;
}

std::vector<std::vector<double>> rotate_inputs(int degree) {
  return with_coefficients(rotate_build_inputs(degree), degree);
}

std::vector<std::vector<double>> rotate_quaternion_inputs(int degree) {
  std::vector<std::vector<double>> inputs;
  for (const RationalQuaternion& q : rotations_for(degree)) append_unit(inputs.emplace_back(), q);
  return with_coefficients(inputs, degree);
}

std::vector<std::vector<double>> rotate_z_inputs(int degree) {
  std::vector<std::vector<double>> inputs;
  for (const RationalQuaternion& q : rotations_for(degree)) {
    // The rotation's angle, about z.
    const Rationals r = rotation_entries({q[0], 0, 0, q[1] + q[2] + q[3]});
    append_rounded(inputs.emplace_back(), {r[0], r[3]});
  }
  return with_coefficients(inputs, degree);
}

std::vector<std::vector<double>> rotate_build_inputs(int degree) {
  std::vector<std::vector<double>> inputs;
  for (const RationalQuaternion& q : rotations_for(degree)) append_rounded(inputs.emplace_back(), rotation_entries(q));
  return inputs;
}

std::vector<std::vector<double>> rotate_apply_inputs(int degree) {
  const int count = degree <= kManyInputs ? 300 : 100;
  std::vector<std::vector<double>> inputs(count);
  for (int l = 0; l <= degree; ++l) {
    const auto rows = unit_vectors(count * (2 * l + 1), 2 * l + 1, kSeed + to_size(l));
    for (std::size_t row = 0; row < rows.size(); ++row) {
      std::vector<double>& input = inputs[row % inputs.size()];
      input.insert(input.end(), rows[row].begin(), rows[row].end());
    }
  }
  return with_coefficients(inputs, degree);
}

std::vector<std::vector<double>> rotate_evaluate_inputs(int degree) {
  const std::vector<std::vector<double>> inputs = rotate_inputs(degree);
  return joined(inputs, unit_vectors(static_cast<int>(inputs.size()), 3, kSeed + 1));
}

}  // namespace sh::codegen
