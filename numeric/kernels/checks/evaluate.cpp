// Values of functions: evaluate (c, d), evaluate_rgb (c of three channels, d); evaluate_prepare c -> polynomial and
// evaluate_prepared (polynomial, d). Against sums of numeric's basis.
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "numeric/kernels/checks/checks.hpp"
#include "numeric/kernels/checks/inputs.hpp"
#include "numeric/kernels/checks/polynomial_forms.hpp"
#include "numeric/oracle/basis.hpp"
#include "numeric/sampling/error_stats.hpp"

namespace sh::numeric {
namespace {

constexpr int kRandomDirections = 150;
constexpr int kVectors = 59;

FamilyCheck value_check(const std::string& family, int channels) {
  const auto inputs_before = [channels](int degree) { return channels * coefficient_count(degree); };
  return {
      .family = family,
      .signature =
          [channels, inputs_before](int degree) {
            Signature signature{{in_array("c", inputs_before(degree)), scalar("x"), scalar("y"), scalar("z")}};
            signature.returns_value = channels == 1;
            if (channels > 1) signature.parameters.push_back(out_array("rgb", channels));
            return signature;
          },
      .inputs =
          [channels](int degree) {
            auto vectors = coefficient_inputs(degree, kVectors, 302);
            for (int i = 1; i < channels; ++i) {
              const auto more = coefficient_inputs(degree, kVectors - i, static_cast<std::uint64_t>(302 + i));
              vectors = combined(vectors, more);
            }
            return combined(vectors, direction_inputs(kRandomDirections));
          },
      .oracle =
          [channels, inputs_before](int degree, const auto* in, auto* out) {
            const auto* const d = in + inputs_before(degree);
            const auto values = basis(degree, d[0], d[1], d[2]);
            for (int channel = 0; channel < channels; ++channel) {
              out[channel] = 0;
              for (const auto& value : values) out[channel] += *in++ * value;
            }
          },
      .nearest = with_unit_direction(inputs_before, [inputs_before](int degree) { return inputs_before(degree) + 3; }),
      .size =
          [](int degree, const double* in, std::size_t output) {
            const int count = coefficient_count(degree);
            return length(in + output * static_cast<std::size_t>(count), count) * band_maximum(degree);
          },
      .unit = "|c| sqrt((2L+1)/4pi)"};
}

// The lengths of the rows of prepare_matrix.
const std::vector<double>& row_lengths(int degree) {
  static std::map<int, std::vector<double>> all;
  auto& lengths = all[degree];
  if (!lengths.empty()) return lengths;
  const int count = coefficient_count(degree);
  std::vector<double> row;
  for (const auto& entry : prepare_matrix(degree)) {
    row.push_back(static_cast<double>(entry));
    if (row.size() < static_cast<std::size_t>(count)) continue;
    lengths.push_back(length(row.data(), count));
    row.clear();
  }
  return lengths;
}

// Polynomials of functions with |c| = 1.
std::vector<NamedInput> prepared_functions(int degree) {
  auto inputs = coefficient_inputs(degree, kVectors, 306);
  for (auto& input : inputs) {
    const auto c = input.values;
    multiply(prepare_matrix(degree), c.size(), c.data(), input.values.data());
  }
  return inputs;
}

}  // namespace

FamilyCheck evaluate_check() { return value_check("evaluate", 1); }
FamilyCheck evaluate_rgb_check() { return value_check("evaluate_rgb", 3); }

FamilyCheck evaluate_prepare_check() {
  return {
      .family = "evaluate_prepare",
      .signature =
          [](int degree) {
            const int count = coefficient_count(degree);
            return Signature{{in_array("c", count), out_array("polynomial", count)}};
          },
      .inputs = [](int degree) { return coefficient_inputs(degree, 2 * kVectors, 306); },
      .oracle =
          [](int degree, const auto* in, auto* out) {
            multiply(prepare_matrix(degree), static_cast<std::size_t>(coefficient_count(degree)), in, out);
          },
      .nearest = {},
      .size = [](int degree, const double* in,
                 std::size_t output) { return row_lengths(degree)[output] * length(in, coefficient_count(degree)); },
      .unit = "the largest that this coefficient of the polynomial gets from |c|"};
}

FamilyCheck evaluate_prepared_check() {
  return {
      .family = "evaluate_prepared",
      .signature =
          [](int degree) {
            return Signature{{in_array("polynomial", coefficient_count(degree)), scalar("x"), scalar("y"), scalar("z")},
                             true};
          },
      .inputs = [](int degree) { return combined(prepared_functions(degree), direction_inputs(kRandomDirections)); },
      .oracle =
          [](int degree, const auto* in, auto* out) {
            using Real = std::remove_cvref_t<decltype(*in)>;
            const auto* const d = in + coefficient_count(degree);
            *out = 0;
            for (const auto& term : prepared_terms(degree)) {
              Real value = *in++;
              for (int i = 0; i < term.i; ++i) value *= d[0];
              for (int j = 0; j < term.j; ++j) value *= d[1];
              *out += term.k == 0 ? value : Real(value * d[2]);
            }
          },
      .nearest = with_unit_direction(coefficient_count, [](int degree) { return coefficient_count(degree) + 3; }),
      .size = [](int degree, const double* /*in*/, std::size_t /*output*/) { return band_maximum(degree); },
      .unit = "|c| sqrt((2L+1)/4pi)"};
}

}  // namespace sh::numeric
